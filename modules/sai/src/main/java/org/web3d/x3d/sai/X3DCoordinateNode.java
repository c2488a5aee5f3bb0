package org.web3d.x3d.sai;

/** Positions of vertices (X3D 4.0, clause 11). */
public interface X3DCoordinateNode extends X3DGeometricPropertyNode {}
