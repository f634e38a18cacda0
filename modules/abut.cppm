// Everything of abut that a C++ program uses.
export module abut;
export import abut.core;
export import abut.math;
export import abut.shape;
export import abut.registry;
export import abut.any_shape;
export import abut.contact;
export import abut.universe;
