"""A folder as a disk keeps it: what is there for certain, and what a power cut may leave of it.

The model is the one of POSIX, stricter than any usual file system: bytes are on the disk once their
file was synced, names once their folder was. Until then each new name, rename and removal may have
got there or not, alone or with others, and each byte written may be old, new, zero or garbage.
"""

from itertools import combinations

GARBAGE = bytes(range(1, 256))
LEAVINGS = ("lost", "zeros", "garbage", "half", "all")  # what is left of bytes that were not synced


class File:
    """Bytes with a past; `on_disk` is what was last synced."""

    def __init__(self, data=b""):
        self.data = bytearray(data)
        self.on_disk = bytes(data)
        self.unsynced = []  # ranges written since

    def write(self, offset, data):
        end = offset + len(data)
        self.data.extend(bytes(max(0, end - len(self.data))))
        self.data[offset:end] = data
        self.unsynced.append((offset, end))

    def truncate(self, length):
        self.data = self.data[:length].ljust(length, b"\0")
        self.unsynced.append((min(length, len(self.on_disk)), length))

    def sync(self):
        self.on_disk = bytes(self.data)
        self.unsynced = []

    def left(self, how):
        if how == "lost" or not self.unsynced:
            return self.on_disk
        data = bytearray(self.data)
        if how == "half":
            first, last = self.unsynced[-1]
            return bytes(data[: (first + last) // 2])
        for first, last in self.unsynced if how != "all" else ():
            last = min(last, len(data))
            filling = GARBAGE * ((last - first) // len(GARBAGE) + 1)
            data[first:last] = filling[: last - first] if how == "garbage" else bytes(last - first)
        return bytes(data)


class Disk:
    """Replays a log of faults.cpp, one call after another."""

    def __init__(self, files):
        self.names = {name: File(data) for name, data in files.items()}
        self.on_disk = dict(self.names)
        self.pending = []  # changes of names since the folder was synced
        self.open_files = {}

    def files(self):
        """The folder as programs see it."""
        return {name: bytes(file.data) for name, file in self.names.items()}

    def replay(self, line):
        call, *arguments = line.split()
        if not call.startswith(("failed-", "read", "close")):
            getattr(self, "_" + call)(*arguments)

    def after_power_cut(self):
        """Every folder that may be found when the power is back."""
        for names in self._possible_names():
            for how in LEAVINGS:
                yield {name: file.left(how) for name, file in names.items()}

    def _possible_names(self):
        for count in range(len(self.pending) + 1):
            for changes in combinations(self.pending, count):
                names = dict(self.on_disk)
                for change in changes:
                    change(names)
                yield names

    def _change(self, change):
        change(self.names)
        self.pending.append(change)

    def _open(self, number, path, how):
        name = path.removeprefix("./")
        if name not in self.names and name != ".":
            file = File()
            self._change(lambda names: names.update({name: file}))
        if how == "truncate":
            self.names[name].truncate(0)
        self.open_files[number] = self.names.get(name)

    def _write(self, number, offset, data):
        self.open_files[number].write(int(offset), bytes.fromhex(data))

    def _truncate(self, number, length):
        self.open_files[number].truncate(int(length))

    def _fsync(self, number):
        file = self.open_files[number]
        if file is None:  # the folder
            self.on_disk = dict(self.names)
            self.pending = []
        else:
            file.sync()

    def _rename(self, a, b):
        a, b = a.removeprefix("./"), b.removeprefix("./")
        file = self.names[a]

        def change(names):
            names.pop(a, None)
            names[b] = file

        self._change(change)

    def _unlink(self, path):
        self._change(lambda names: names.pop(path.removeprefix("./"), None))
