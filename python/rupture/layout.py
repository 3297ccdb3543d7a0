"""The datasets of docs/schema.md. A file that is opened must have these and no others, whoever
sealed it, and values on which programs can rely."""

import re
from math import prod

import numpy as np
from h5py import h5a, h5d, h5g, h5l, h5o

from rupture.errors import Failure
from rupture.tables import text

# Group, names and type[lengths]. A name with "?" may be missing, a group with "?" as a whole.
# Lengths that do not follow from the parameters are those of the first dataset that has them. With
# "|", a property of the interface: one value, or one for each block.
BOTH = """
parameters/slider     L,H,B,M,E,F_N,damping,foundation,foundation_damping? float64  Nx,Nz int64
parameters/slider     load? float64|float64[Nx]
parameters/slider     springs?,edge_springs?,damping_along?,support text
parameters/driving    K,h,V float64
parameters/junctions  mu_s,mu_d,mu_new,kappa,t_R,delta_t_R float64|float64[Nx]
parameters/junctions  d_R?,delta_d_R?,v_slow float64|float64[Nx]  f_new text|int64[Nx]
parameters/junctions  N_s int64  law,k_ij_from?,slipping_times,without_contact?,repin? text
parameters/numerics   dt float64  seed int64
provenance/*          tool,version,commit,command_line,compiler,parent_checksum,rebuild text
run                   id? text  first_step?,last_break?,ruptures? int64
run                   quiet_steps?,until_rupture_of? int64
run                   leading_edge_ruptured?,spanned?,until_spanned? uint8  event? float64[Nx]
run                   last_rupture?,arrived_below?,record_every?,fields_every? float64
run                   record_every_in_events?,record_every_in_spanning_events? float64
run                   quiet_time?,condition_every? float64  condition? text
"""
CHECKPOINT = """\
state                 step int64  u_x,u_z,v_x,v_z,f_x,f_z float64[Nz][Nx]
alarm?                sentence text
state/clock?          origin_step int64  origin_time float64
state/drive           origin_step int64  origin_position float64
state/junctions       repin_time,attachment,slow_until?,slip_left? float64[Nx][S]
state/junctions       slipping uint8[Nx][S]  draws uint32[Nx][S]
"""
RECORD = """\
series                time,F_T,x_drive float64[n]  step int64[n]  pinned uint16[n][Nx]
series                p,tau,u_x float64[n][Nx]  x? float64[Nx]
ruptures              time float64[r]  step,block int64[r]
crossings?            time,pinned_below float64[c]  step,block int64[c]  levels float64[k]
fields?               time float64[m]  step int64[m]  u_x,u_z float32[m][Nz][Nx]
fields?               x? float64[Nx]  z? float64[Nz]
"""
TABLES = {"checkpoint": BOTH + CHECKPOINT, "record": BOTH + RECORD}
SCHEMAS = (2, 3)
CONVERT = {
    "checkpoint": "convert it once with rupture 0.4.0: rupture restart OLD.h5 --for 0 -o NEW.h5",
    "record": "make the record again with the command that rupture analyze show of rupture 0.4.0"
    " prints",
}
LENGTH = re.compile(r"\[(\w+)\]")
WORDS = {"junctions.f_new": ("zero", "f_slip")}  # by their number, where each block has its own
# Least and greatest value by name; "S" is the number of junctions of a block.
LIMITS: dict = dict.fromkeys(("L", "H", "B", "M", "E", "dt"), (1e-99, 1e13))
LIMITS |= {"Nx": (3, 65536), "Nz": (2, 65536), "N_s": (1, 1e6), "slipping": (0, 1)}
LIMITS |= {"pinned": (0, "S"), "block": (0, "last"), "f_new": (0, 1)}


def rows_of(kind):
    """Yields (path, (type[lengths], the beginning of the paths with one of which it is needed))."""
    for line in TABLES[kind].strip().splitlines():
        group, *words = line.split()
        for names, form in zip(words[::2], words[1::2]):
            for name in names.split(","):
                needed = None if "?" in name else f"/{group[:-1]}/" if "?" in group else "/"
                yield f"/{group}/{name}".replace("?", ""), (form, needed)


class Content(dict):
    """type[lengths] of the datasets of a file or piece, by path."""

    def __init__(self, file, path, header, size):
        super().__init__()
        self.path, self.kind, self.size, self.room = path, header.split("-")[1], size, size
        self.rows = dict(rows_of(self.kind))
        for name in ("format", "schema_version", "content_checksum"):
            self.check_attribute(file.id, name, "the file")
        said, schema = text(file.attrs["format"]), file.attrs["schema_version"]
        if schema < SCHEMAS[0]:
            reads = f"this version reads schemas {SCHEMAS[0]} and {SCHEMAS[-1]}"
            self.fail(f"it has schema {schema}; {reads}: {CONVERT[self.kind]}")
        if said != header or schema not in SCHEMAS:
            reads = f"expected {header}, schema {SCHEMAS[0]} or {SCHEMAS[-1]}"
            said = f"its attributes say {said}, schema {schema}"
            self.fail(f"{said}; {reads}: use a newer rupture, or recreate it")
        self.collect(file.id, "")

    def fail(self, sentence):
        raise Failure(f"{self.path}: {sentence}")

    def check_attribute(self, item, name, where):
        made = h5a.open(item, name.encode())
        if made.shape or made.dtype.kind not in "iS" or made.dtype.itemsize > 1000:
            self.fail(f"the attribute {name} of {where} is not one number or short text")

    def collect(self, group, where):
        links: list = []
        group.links.iterate(lambda name, link: links.append((name, link.type)), info=True)
        for name, kind in links:
            path = f"{where}/{name.decode(errors='replace')}"
            row = re.sub("^/provenance/[^/]+", "/provenance/*", path)
            item = h5o.open(group, name) if kind == h5l.TYPE_HARD else None
            if row in self.rows and isinstance(item, h5d.DatasetID):
                self.add(item, path)
            elif isinstance(item, h5g.GroupID) and any(p.startswith(row + "/") for p in self.rows):
                self.collect(item, path)
            else:
                self.fail(f"{path} is a link, or not part of a {self.kind}: use a newer rupture")

    def add(self, item, path):
        made = item.get_create_plist()
        is_here = made.get_layout() < h5d.CHUNKED and not made.get_external_count()
        # Asked for its shape, a virtual dataset would open others.
        size = item.get_type().get_size() * prod(item.shape) if is_here else self.size + 1
        self.room -= size  # all together must fit into the file
        end = (item.get_offset() or 0) + size
        if self.room < 0 or end > self.size or item.get_storage_size() != size:
            self.fail(f"{path} is not stored as rupture does, in one piece in this file")
        for name in ("unit", "long_name") if h5a.exists(item, b"long_name") else ("unit",):
            self.check_attribute(item, name, path)
        kind = item.dtype
        name = "text" if kind.kind == "S" else kind.name if kind.isnative else kind.str
        self[path] = name + "".join(f"[{length}]" for length in item.shape)

    def check(self, file):
        """Looks for what is missing, and at types and lengths; the parameters come first."""
        steps = sorted({path.split("/")[2] for path in self if path.startswith("/provenance/")})
        for row, (form, needed) in self.rows.items():
            for path in [row.replace("*", step) for step in steps] if "*" in row else [row]:
                found = self.get(path, "missing")
                is_needed = needed and any(one.startswith(needed) for one in ["/", *self])
                if found == "missing" and not is_needed:
                    continue
                form = form.split("|")[-1 if "[" in found else 0]
                for symbol, length in zip(LENGTH.findall(form), LENGTH.findall(found)):
                    file.sizes.setdefault(symbol, length)
                wanted = LENGTH.sub(lambda n: f"[{file.sizes.get(n[1], n[1])}]", form)
                if found != wanted:
                    self.fail(f"{path} is {found}; expected {wanted}")

    def check_values(self, path, values, file):
        """Call it for all values that are read."""
        name, numbers = path.split("/")[-1], np.atleast_1d(values)
        is_of_alarm = "/alarm/sentence" in self and path.startswith("/state/")
        if numbers.dtype.kind == "f" and not is_of_alarm:
            if (odd := numbers[~np.isfinite(numbers)]).size:
                self.fail(f"{path} holds {odd[0]}; only finite numbers are stored")
        if name in LIMITS and numbers.dtype.kind in "fiu":
            least, most = (file.sizes[end] if end in ("S", "last") else end for end in LIMITS[name])
            if (odd := numbers[(numbers < least) | (numbers > most)]).size:
                self.fail(f"{path} holds {odd[0]}; expected {least:g} to {most:g}")
        if path in ("/series/time", "/fields/time") and (numbers[1:] <= numbers[:-1]).any():
            self.fail(f"{path} does not ascend")
