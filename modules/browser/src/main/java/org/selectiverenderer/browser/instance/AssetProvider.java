package org.selectiverenderer.browser.instance;

import java.util.Optional;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.x3d.shader.ShaderSource;

/**
 * Provides the meshes of geometry nodes, the images of texture nodes and the sources of shader
 * parts. They are made while the scene loads and are kept.
 */
public interface AssetProvider {
  /**
   * Returns the mesh of a geometry node for its present field values; empty if the node cannot be
   * drawn.
   */
  Optional<Mesh> mesh(Node geometry);

  /** Returns the image of a texture node; empty if it has none or it could not be read. */
  Optional<Texture.Image> image(Node texture);

  /**
   * Returns the source of a ShaderPart or ShaderProgram; empty if it has none or it could not be
   * read.
   */
  Optional<ShaderSource> shader(Node part);

  /** Reports a problem of a shader program, which is found only when it is first drawn. */
  void told(Problem problem);

  /**
   * Returns the texture node made for one side of a Background; empty if that side has no url.
   *
   * @param background a Background node
   */
  default Optional<Node> picture(Node background, Background.Side side) {
    return Optional.empty();
  }

  /**
   * Returns whether the colours of an Appearance's texture multiply the material's, as they do
   * since X3D 4.0 (17.2.2). In earlier versions a texture of three or four components replaced the
   * material's colour (X3D 3.3, 17.2.2.4).
   */
  boolean multiplies(Node texture);

  /**
   * Announces that a geometry or texture node is about to be shown. If it has changed since its
   * asset was made, perhaps while nobody observed it, the asset is dropped.
   *
   * @param changes how often the node and all nodes in it have changed
   */
  void asOf(Node node, int changes);

  /**
   * Drops the asset of a node whose fields have changed: a geometry node or a node in it, a texture
   * node or a shader part.
   */
  void changed(Node node);
}
