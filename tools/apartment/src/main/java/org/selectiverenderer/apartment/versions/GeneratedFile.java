package org.selectiverenderer.apartment.versions;

/**
 * A generated file for {@code inlineNodes/}.
 *
 * @param name the file's name, {@code trashCan_v1.x3d}
 * @param polygons number of triangles in the file
 */
public record GeneratedFile(String name, int polygons, String text) {}
