package org.web3d.x3d.sai.texturing;

import org.web3d.x3d.sai.X3DTexture2DNode;
import org.web3d.x3d.sai.X3DUrlObject;

/** An image from a file (X3D 4.0, clause 18). */
public interface ImageTexture extends X3DTexture2DNode, X3DUrlObject {}
