package org.web3d.x3d.sai;

/** Values for the vertices of geometry (X3D 4.0, clause 11). */
public interface X3DGeometricPropertyNode extends X3DNode {}
