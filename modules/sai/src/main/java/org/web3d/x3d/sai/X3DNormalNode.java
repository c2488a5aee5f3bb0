package org.web3d.x3d.sai;

/** Directions that faces or vertices face (X3D 4.0, clause 11). */
public interface X3DNormalNode extends X3DGeometricPropertyNode {}
