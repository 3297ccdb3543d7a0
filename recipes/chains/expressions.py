"""Expressions in files of sweeps: numbers, texts, names, arithmetic, comparisons, lists and a few
functions. They are parsed and then worked out here, never run. Mistakes are ValueErrors.

Null is None. What is computed from it is null, and so is a comparison with it."""

import ast
import math
import operator
import re
import statistics
from functools import cache

from rupture.units import in_si, one_name

ARITHMETIC = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
    ast.Pow: lambda one, other: float(one) ** float(other),  # of whole numbers: without end
}
SIGNS = {ast.UAdd: operator.pos, ast.USub: operator.neg, ast.Not: operator.not_}
COMPARISONS = {
    ast.Lt: operator.lt,
    ast.LtE: operator.le,
    ast.Gt: operator.gt,
    ast.GtE: operator.ge,
    ast.Eq: operator.eq,
    ast.NotEq: operator.ne,
    ast.In: lambda one, several: one in several,
    ast.NotIn: lambda one, several: one not in several,
    ast.Is: operator.is_,
    ast.IsNot: operator.is_not,
}
FUNCTIONS = {
    "abs": abs,
    "enumerate": lambda values: list(enumerate(values)),
    "known": lambda values: [value for value in values if value is not None],
    "len": len,
    "max": lambda *values: extreme(max, *values),
    "median": lambda values: extreme(statistics.median, values),
    "min": lambda *values: extreme(min, *values),
    "round": round,
    "sqrt": math.sqrt,
    "zip": lambda *lists: list(zip(*lists)),
}
ALLOWED = (
    *(ast.Expression, ast.Name, ast.Attribute, ast.Subscript, ast.Tuple, ast.List, ast.BinOp),
    *(ast.UnaryOp, ast.BoolOp, ast.Compare, ast.And, ast.Or, ast.Load),
    *(ast.ListComp, ast.comprehension, ast.Slice, ast.Store),
    *(*ARITHMETIC, *SIGNS, *COMPARISONS),
)
MAY_HAVE = "numbers, texts, names, + - * / **, comparisons, and, or, not, [a for b in c if d], " + (
    ", ".join(f"{name}()" for name in FUNCTIONS)
)
MINUS = "_minus_"  # stands for the - of names such as sigma-bar
WORD = re.compile(r"\w[\w.-]*")
WHOLE = 1e15  # up to there, whole numbers are written without an exponent


class Expression:
    """`names` that it may have are needed for those with a -, such as sigma-bar. Its own `names`
    are those that are looked up, as long as they are written."""

    def __init__(self, text, names=()):
        self.text = text.strip()
        self.tree, self.names = parsed(self.text, frozenset(one for one in names if "-" in one))

    def value(self, look_up):
        """`look_up(name)` is asked for names, the longest first (front.t_rupture, then front), and
        raises KeyError for those that it does not know."""
        try:
            return worked_out(self.tree.body, look_up)
        except KeyError as error:
            raise ValueError(f"'{self.text}': there is no {error.args[0]}") from None
        except (ArithmeticError, IndexError, RecursionError, TypeError) as error:
            raise ValueError(f"'{self.text}' cannot be worked out: {error}") from None


@cache  # many points have the same
def parsed(text, names):
    """The tree, and the names in it; `names`: those with a -."""
    plain = text
    for name in sorted(names, key=len, reverse=True):
        alone = rf"(?<![\w.-]){re.escape(name)}(?![\w-])"
        plain = re.sub(alone, name.replace("-", MINUS), plain)
    try:
        tree = ast.parse(plain, mode="eval")
        for node in ast.walk(tree):
            if isinstance(node, ast.Name):
                node.id = one_name(node.id)
        found = sorted(set(names_in(tree)))
    except (SyntaxError, MemoryError, RecursionError, ValueError):
        raise ValueError(f"'{text}' cannot be read as an expression") from None
    if not all(map(is_allowed, ast.walk(tree))):
        raise ValueError(f"'{text}' is not allowed: it may have {MAY_HAVE}")
    return tree, found


def as_number(text):
    """A value as a condition sees it: a number in SI units, or the text."""
    try:
        return in_si(text)[0] if isinstance(text, str) else text
    except ValueError:
        return text


def as_text(value):
    """A value as a command has it: with all digits, and without a dot if it is whole. A text is a
    word, which cannot be read as an option or as a path."""
    if isinstance(value, float) and value.is_integer() and abs(value) < WHOLE:
        return str(int(value))
    if isinstance(value, str) and not WORD.fullmatch(value):
        raise ValueError(f"'{value}' is neither a number nor a word")
    return value if isinstance(value, str) else repr(value)


# --- names -------------------------------------------------------------------------------------


def dotted(node):
    """`a.b.c` of such names; nothing for other expressions."""
    if isinstance(node, ast.Attribute):
        before = dotted(node.value)
        return before and f"{before}.{node.attr}"
    return node.id.replace(MINUS, "-") if isinstance(node, ast.Name) else ""


def names_in(node):
    if name := dotted(node):
        return [name]
    parts = node.args if isinstance(node, ast.Call) else ast.iter_child_nodes(node)
    names = [name for part in parts for name in names_in(part)]
    if isinstance(node, ast.ListComp):  # its own are given in it
        own = {n.id for of in node.generators for n in ast.walk(of.target) if hasattr(n, "id")}
        return [name for name in names if name.partition(".")[0] not in own]
    return names


def beginnings(name):
    """Yields the beginnings of a name with dots, longest first, each with the words after it."""
    words = name.split(".")
    return ((".".join(words[:n]), words[n:]) for n in range(len(words), 0, -1))


def first_known(name, names):
    """The longest beginning that is one of these names; nothing if none is."""
    return next((first for first, _ in beginnings(name) if first in names), "")


def named(name, look_up):
    """What a name with dots leads to: its longest known beginning, and what is in there."""
    for first, words in beginnings(name):
        try:
            found = look_up(first)
        except KeyError:
            continue
        for word in words:
            found = part_of(found, word)
        return found
    raise KeyError(name)


def part_of(whole, key):
    """An entry of a report, or an element of a list; of null it is null."""
    if isinstance(whole, dict) and key not in whole:
        raise KeyError(f"'{key}' (there are {', '.join(whole)})")
    if isinstance(key, float) and key.is_integer():  # a value
        key = int(key)
    return None if whole is None else whole[key]


# --- values ------------------------------------------------------------------------------------


def is_allowed(node):
    if isinstance(node, ast.Constant):
        return isinstance(node.value, (int, float, str, type(None)))
    if isinstance(node, ast.Call):
        return dotted(node.func) in FUNCTIONS and not node.keywords
    if isinstance(node, ast.ListComp):
        target = node.generators[0].target
        names = target.elts if isinstance(target, ast.Tuple) else [target]
        return len(node.generators) == 1 and all(isinstance(name, ast.Name) for name in names)
    return isinstance(node, ALLOWED)


def worked_out(node, look_up):
    def of(part):
        return worked_out(part, look_up)

    if name := dotted(node):
        return named(name, look_up)
    match node:
        case ast.Constant():
            return node.value
        case ast.Attribute():
            return part_of(of(node.value), node.attr)
        case ast.Subscript():
            return part_of(of(node.value), of(node.slice))
        case ast.Slice():
            return slice(*(part and of(part) for part in (node.lower, node.upper)))
        case ast.ListComp():
            return listed(node, look_up)
        case ast.BoolOp():
            return chosen(isinstance(node.op, ast.Or), map(of, node.values))
        case ast.UnaryOp():
            return of_known(SIGNS[type(node.op)], of(node.operand))
        case ast.BinOp():
            return of_known(arithmetic, type(node.op), of(node.left), of(node.right))
        case ast.Compare():
            return compared(node, of)
        case ast.Call():
            return of_known(FUNCTIONS[dotted(node.func)], *map(of, node.args))
    return [of(part) for part in node.elts]  # a list


def listed(node, look_up):
    """[a for b in c if d], with one list; null if the list is."""
    [one] = node.generators
    if (elements := worked_out(one.iter, look_up)) is None:
        return None
    found = []
    for element in elements:

        def inside(name, given=given(one.target, element)):
            return given[name] if name in given else look_up(name)

        if all(worked_out(condition, inside) for condition in one.ifs):
            found.append(worked_out(node.elt, inside))
    return found


def given(target, element):
    """{name: value} of one name, or of several: a, b"""
    if isinstance(target, ast.Name):
        return {target.id: element}
    return dict(zip((name.id for name in target.elts), element, strict=True))


def of_known(function, *values):
    """Null if one of the values is."""
    return None if any(value is None for value in values) else function(*values)


def extreme(which, *values):
    """Returns max or min of a list, or of several numbers; null if there are none."""
    numbers = values[0] if len(values) == 1 else values
    return of_known(lambda *known: which(known), *numbers) if numbers else None


def arithmetic(sign, *values):
    """Arithmetic is for numbers: a text could be repeated any number of times."""
    if not all(isinstance(value, (int, float)) for value in values):
        raise TypeError("arithmetic is for numbers")
    found = ARITHMETIC[sign](*values)
    if isinstance(found, complex) or not math.isfinite(found):
        raise ArithmeticError("it is not a finite real number")
    return found


def chosen(is_or, values):
    """`a or b` is b where a is null or false, `a and b` is a there."""
    for value in values:
        if bool(value) == is_or:
            break
    return value


def compared(node, of):
    """A chain of comparisons, as in 0 < a < 1."""
    left, answer = of(node.left), True
    for sign, part in zip(node.ops, node.comparators):
        right = of(part)
        compare = COMPARISONS[type(sign)]
        is_of_null = isinstance(sign, (ast.Is, ast.IsNot))
        answer = compare(left, right) if is_of_null else of_known(compare, left, right)
        if not answer:
            break
        left = right
    return answer
