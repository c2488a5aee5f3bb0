package org.selectiverenderer.polygon;

/**
 * A picture that a texture shows.
 *
 * @param key equal for textures that show the same picture
 * @param bytes its bytes in the memory of a graphics card, with mip maps
 */
public record TexturePicture(Object key, long bytes) {}
