# SPDX-License-Identifier: GPL-2.0-or-later
"""The size in pixels of a texture by its name, as registered by the painters in textures.py."""

DEFAULT = (128, 128)
_sizes = {}


def register_size(name, width, height):
    _sizes[name] = (width, height)


def texture_size(name):
    return _sizes.get(name, DEFAULT)
