# SPDX-License-Identifier: MIT
"""Parses comments of the public header: the text on a function's parameters, statuses and threads."""
import re

# Texts for parameters that the comment does not explain.
COMMON_PARAMETERS = {
    "world": "the world",
    "batch": "handle of a batch of the world",
    "a": "handle of a batch of the world",
    "b": "handle of a batch of the world",
    "asset": "the asset",
    "body": "id of a body",
    "bodies": "`count` ids of bodies",
    "collider": "handle of a collider",
    "colliders": "`count` handles of colliders",
    "source": "handle of a wind source of the world",
    "desc": "initialised by its `_init` function, or with struct_size set",
    "struct_size": "sizeof the struct in the caller's header",
    "count": "number of elements",
    "capacity": "number of elements that fit",
    "kinds": "bits, see above",
    "out_ids": "receives `count` ids; may be null",
    "memory": "the bytes",
    "size": "number of bytes",
    "format": "one of the constants above",
    "level": "one of LR_LOG_*",
    "user": "passed to each call of the function",
}


def text_of(comment):
    """The lines of a comment without its frame."""
    lines = comment[2:-2].strip("\n").split("\n")
    lines[0] = lines[0].removeprefix(" ")
    return [re.sub(r"^\s*\*(?: |$)", "", line).rstrip() for line in lines]


def parameter_start(names):
    """Matches "name: " or "name, name: " at the start of a text on a parameter."""
    name = "|".join(map(re.escape, names))
    return rf"(?:(?<=^)|(?<=\n)|(?<=[.;] )|(?<=[.;]\n))((?:{name})(?:(?:, | and )(?:{name}))*): "


STATUSES_START = r"(?:(?<=\n)|(?<=^)|(?<=\. ))(LR_OK\b)"


def split(text, names):
    """The parts of a function's comment: (summary, {parameter: text}, statuses, threads), each possibly empty."""
    threads = ""
    match = re.search(r"(?<=[.)])\s+(Any thread\.)", text)
    if match:
        threads = match.group(1)
        text = text[:match.start()] + text[match.end():]
    returns = ""
    match = re.search(STATUSES_START, text)
    if match and not re.match(r"LR_OK, or", text):
        returns = text[match.start():].strip()
        text = text[:match.start()]
    said = {}
    if names:
        parts = re.split(parameter_start(names), text)
        text = parts[0]
        for of, words in zip(parts[1::2], parts[2::2]):
            for name in re.split(r", | and ", of):
                said[name] = words.strip()
    for name in names:
        if name not in said and name in COMMON_PARAMETERS:
            said[name] = COMMON_PARAMETERS[name]
    return text.strip(), said, returns, threads
