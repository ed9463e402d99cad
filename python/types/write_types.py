"""write_types.py TYPES OUTPUT: the types of the module, with its steps, methods and options."""

import sys

import espalier

CLASSES = "# The classes of steps stand here.\n"
PROPERTIES = "    # The properties of steps stand here.\n"


def main(source: str, output: str) -> None:
    options = espalier.Options()
    steps = {
        name: type(getattr(options, name))
        for name in vars(espalier.Options)
        if isinstance(getattr(options, name, None), espalier.StepOptions)
    }
    with open(source, encoding="utf-8") as file:
        text = file.read().split("\n", 1)[1]  # without what is said of the source
    assert CLASSES in text and PROPERTIES in text
    text = text.replace(CLASSES, "\n".join(map(class_of, steps.values())))
    text = text.replace(
        PROPERTIES,
        "".join(
            f"    @property\n    def {name}(self) -> {kind.__name__}: ...\n"
            for name, kind in steps.items()
        ),
    )
    with open(output, "w", encoding="utf-8") as file:
        file.write("# Made by write_types.py.\n" + text)


def class_of(kind: type) -> str:
    return f"class {kind.__name__}(StepOptions):\n" + "".join(
        f"    @property\n    def {name}(self) -> {value}: ...\n"
        f"    @{name}.setter\n    def {name}(self, value: {value}) -> None: ...\n"
        f"    @{name}.deleter\n    def {name}(self) -> None: ...\n"
        for name, value in kind.__annotations__.items()
    )


main(*sys.argv[1:])
