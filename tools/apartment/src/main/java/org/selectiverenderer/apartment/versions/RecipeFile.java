package org.selectiverenderer.apartment.versions;

/**
 * A file in {@code inlineNodes/}.
 *
 * @param name the file's name, {@code trashCan_v1.x3d}
 * @param polygons triangles that it holds
 */
public record RecipeFile(String name, int polygons, String text) {}
