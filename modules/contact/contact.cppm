// What happens to manifolds after they were found.
export module abut.contact;
export import abut.contact.reduce;
