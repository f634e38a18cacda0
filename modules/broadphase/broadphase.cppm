// From boxes to pairs of boxes that overlap.
export module abut.broadphase;
export import abut.broadphase.brute;
export import abut.broadphase.proxy;
export import abut.broadphase.tree;
