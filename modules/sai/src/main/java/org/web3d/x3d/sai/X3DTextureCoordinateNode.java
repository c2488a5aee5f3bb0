package org.web3d.x3d.sai;

/** Places in an image for vertices (X3D 4.0, clause 18). */
public interface X3DTextureCoordinateNode extends X3DGeometricPropertyNode {}
