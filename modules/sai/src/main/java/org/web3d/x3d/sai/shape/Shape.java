package org.web3d.x3d.sai.shape;

import org.web3d.x3d.sai.X3DShapeNode;

/** Geometry with its appearance (X3D 4.0, clause 12). */
public interface Shape extends X3DShapeNode {}
