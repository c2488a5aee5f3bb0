package org.selectiverenderer.runtime.nodes.shape;

import java.util.Optional;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.geometry.mesh.MeshCopies;
import org.selectiverenderer.geometry.tessellate.InstancePlaces;
import org.selectiverenderer.runtime.scene.Formed;
import org.selectiverenderer.runtime.scene.Node;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeType;

/**
 * InstancedShape, an extension of X_ITE: one geometry in many places, drawn as one mesh of all
 * copies. Copies beyond {@link MeshCopies#most} are left out.
 */
public final class InstancedShapeNode extends Node implements Formed {
  private Function<Node, Optional<Mesh>> meshes = node -> Optional.empty();
  private final int[] lists;
  private @Nullable Mesh each;
  private Object[] known = {};
  private @Nullable Mesh all;

  public InstancedShapeNode(NodeType type, @Nullable String name, Location location) {
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
      all = now == null ? null : MeshCopies.of(now, InstancePlaces.of(this, MeshCopies.most(now)));
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
