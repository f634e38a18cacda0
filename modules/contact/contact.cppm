// What happens to manifolds after they were found.
export module abut.contact;
export import abut.contact.cap;
export import abut.contact.reduce;
export import abut.contact.reduce_children;
