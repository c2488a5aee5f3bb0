package org.selectiverenderer.browser.nodes.shape;

import java.util.Optional;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.scene.ProceduralShape;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.geometry.mesh.MeshReplicator;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.tessellate.InstancedShapeTransforms;

/**
 * InstancedShape, an extension of X_ITE: one geometry in many places, drawn as one mesh of all
 * copies. Copies beyond {@link MeshReplicator#most} are left out.
 */
public final class InstancedShapeNode extends Node implements ProceduralShape {
  private Function<Node, Optional<Mesh>> meshes = node -> Optional.empty();
  private final int[] lists;
  private @Nullable Mesh each;
  private Object[] known = {};
  private @Nullable Mesh all;

  public InstancedShapeNode(NodeType type, @Nullable String name, SourceLocation location) {
    super(type, name, location);
    lists =
        type.fields().stream()
            .filter(field -> field.type().multiple())
            .mapToInt(FieldDefinition::index)
            .toArray();
  }

  @Override
  public void meshes(Function<Node, Optional<Mesh>> source) {
    meshes = source;
  }

  @Override
  public Optional<Mesh> form() {
    Node geometry = node("geometry");
    Mesh now = geometry == null ? null : meshes.apply(geometry).orElse(null);
    if (now != each || listsChanged()) {
      each = now;
      all =
          now == null
              ? null
              : MeshReplicator.of(now, InstancedShapeTransforms.of(this, MeshReplicator.most(now)));
    }
    return Optional.ofNullable(all);
  }

  /**
   * Returns whether a list of transformations is another object than before, and remembers the
   * lists.
   */
  private boolean listsChanged() {
    boolean changed = known.length == 0;
    Object[] now = new Object[lists.length];
    for (int i = 0; i < lists.length; i++) {
      now[i] = value(lists[i]);
      changed |= known.length != 0 && known[i] != now[i];
    }
    known = now;
    return changed;
  }
}
