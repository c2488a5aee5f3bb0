package org.web3d.x3d.sai.rendering;

import org.web3d.x3d.sai.X3DComposedGeometryNode;

/** Triangles of three consecutive coordinates each (X3D 4.0, clause 11). */
public interface TriangleSet extends X3DComposedGeometryNode {}
