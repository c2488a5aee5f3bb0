package org.selectiverenderer.models.gltf.write;

import org.selectiverenderer.x3d.catalogue.NodeView;
import org.selectiverenderer.x3d.read.ParsedNode;
import org.selectiverenderer.x3d.read.X3dFile;
import org.selectiverenderer.x3d.url.BaseUrl;

/**
 * Holds where a node is met.
 *
 * @param file the file that it is in
 * @param key the key of that file's content; "" for the outermost one
 * @param base the base of that file's relative urls
 * @param depth the number of nodes around it
 * @param scale by what those multiply lengths
 */
record GltfPlace(X3dFile file, String key, BaseUrl base, int depth, double scale) {
  /** Returns the place inside of a node that multiplies lengths. */
  GltfPlace inside(double factor) {
    return new GltfPlace(file, key, base, depth + 1, scale * factor);
  }

  /** Returns the base of a node's relative urls. */
  BaseUrl base(NodeView node) {
    return node instanceof ParsedNode parsed ? parsed.base(base) : base;
  }

  /** Returns whether images multiply the colour of a Material, as since X3D 4.0. */
  boolean imagesMultiply() {
    return file.version().startsWith("4");
  }
}
