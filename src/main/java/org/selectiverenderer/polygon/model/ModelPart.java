package org.selectiverenderer.polygon.model;

import java.nio.file.Path;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.x3d.catalogue.NodeView;

/**
 * One surface of a model.
 *
 * @param appearance an Appearance node, or null for none
 * @param mesh its triangles in the model's frame; texture coordinates only where there is a texture
 * @param folder that relative urls in the appearance start from
 */
public record ModelPart(@Nullable NodeView appearance, Mesh mesh, Path folder) {}
