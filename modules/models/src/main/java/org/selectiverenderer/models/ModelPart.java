package org.selectiverenderer.models;

import java.nio.file.Path;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.x3d.catalogue.NodeView;

/**
 * A part of a model: a mesh with its material.
 *
 * @param appearance an Appearance node, or null for none
 * @param mesh its triangles in the model's frame; texture coordinates only where there is a texture
 * @param folder the folder against which relative urls in the appearance are resolved
 */
public record ModelPart(@Nullable NodeView appearance, Mesh mesh, Path folder) {}
