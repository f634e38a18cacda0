// What shapes are: capabilities, records and checks.
export module abut.shape;
export import abut.shape.checks;
export import abut.shape.concepts;
export import abut.shape.cores;
export import abut.shape.edits;
export import abut.shape.frames;
export import abut.shape.part_ball;
export import abut.shape.part_triangle;
export import abut.shape.place;
export import abut.shape.records;
export import abut.shape.rim;
export import abut.shape.ties;
export import abut.shape.walls;
