# What SWIG makes has no hints; the classes above it have them.
from typing import Any

def __getattr__(name: str) -> Any: ...
