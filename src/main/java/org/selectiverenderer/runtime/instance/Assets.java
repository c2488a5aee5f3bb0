package org.selectiverenderer.runtime.instance;

import java.util.Optional;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.runtime.scene.Node;
import org.selectiverenderer.x3d.shader.ShaderText;

/** Gives geometry nodes their meshes and texture nodes their images; made while loading, kept. */
public interface Assets {
  /** The mesh of a geometry node as its fields are; empty for what cannot be drawn. */
  Optional<Mesh> mesh(Node geometry);

  /** The image of a texture node; empty when it has none or it could not be read. */
  Optional<Texture.Image> image(Node texture);

  /** The text of a ShaderPart or ShaderProgram; empty when it has none or it could not be read. */
  Optional<ShaderText> shader(Node part);

  /** Tells what is wrong with a shader's program, which is known when it is drawn. */
  void told(Problem problem);

  /**
   * The texture that stands for a picture which a Background names; empty when it names none.
   *
   * @param background a Background node
   */
  default Optional<Node> picture(Node background, Backdrop.Side side) {
    return Optional.empty();
  }

  /**
   * Whether the colours of an Appearance's texture multiply the material's, as they do since X3D
   * 4.0 (17.2.2); those of three or four components replaced it before (3.3, 17.2.2.4).
   */
  boolean multiplies(Node texture);

  /**
   * A geometry or texture node is about to be shown, and has changed before, perhaps while nobody
   * observed it: an asset that was made earlier is forgotten.
   *
   * @param changes how often it has changed, with all nodes in it
   */
  void asOf(Node node, int changes);

  /**
   * A geometry node (or a node in it), a texture node or a part of a shader has other values:
   * forget its asset.
   */
  void changed(Node node);
}
