package org.web3d.x3d.sai.texturing;

import org.web3d.x3d.sai.X3DTexture2DNode;

/**
 * An image given pixel by pixel (X3D 4.0, clause 18); {@link org.web3d.x3d.sai.X3DNode#getField}
 * reaches its image.
 */
public interface PixelTexture extends X3DTexture2DNode {}
