package org.selectiverenderer.models.scene;

/**
 * A node of a model's tree.
 *
 * @param parent the index of its parent; -1 for a root
 * @param name its name in the model, or ""
 * @param place its place in its parent at rest
 */
public record ModelNode(int parent, String name, NodeTransform place) {}
