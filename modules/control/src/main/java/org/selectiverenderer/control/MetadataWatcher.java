package org.selectiverenderer.control;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.DoubleConsumer;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.sai.InlineSceneAccess;
import org.web3d.x3d.sai.X3DField;
import org.web3d.x3d.sai.X3DFieldEventListener;
import org.web3d.x3d.sai.X3DNode;

/**
 * Listens for changes of a node's metadata at every depth: another metadata node, other members of
 * a set, other names or values; and of the metadata of that metadata, where field qualities stand.
 * Field objects are kept, because a browser may know a listener only by the very field object that
 * it was added to. A browser that tells changes of metadata as a whole is asked for that instead.
 */
final class MetadataWatcher {
  private final X3DNode owner;
  private final @Nullable SceneScope scope;
  private final DoubleConsumer told;
  private InlineSceneAccess.@Nullable Registration registration;
  private List<X3DField> watched = List.of();
  private @Nullable X3DFieldEventListener onChange;

  /**
   * Makes a watcher that listens from the first {@link #read()} on.
   *
   * @param onChange called with the time stamp when the metadata has changed
   */
  MetadataWatcher(X3DNode owner, ListenerLock turn, DoubleConsumer onChange) {
    this(owner, null, turn, onChange);
  }

  /**
   * Makes a watcher that listens from the first {@link #read()} on.
   *
   * @param scope knows whether the browser tells changes as a whole; null to listen to the fields
   * @param onChange called with the time stamp when the metadata has changed
   */
  MetadataWatcher(
      X3DNode owner, @Nullable SceneScope scope, ListenerLock turn, DoubleConsumer onChange) {
    this.owner = owner;
    this.scope = scope;
    this.told = time -> turn.take(() -> onChange.accept(time));
  }

  /** Returns the present metadata, and listens for its changes from now on. */
  Optional<SaiMetadata> read() {
    close();
    registration = scope == null ? null : scope.watchMetadata(owner, told).orElse(null);
    if (registration != null) {
      return SaiMetadata.of(owner);
    }
    onChange = event -> told.accept(event.getTime());
    List<X3DField> fields = new ArrayList<>();
    watch(owner, "metadata", fields);
    Optional<SaiMetadata> metadata = SaiMetadata.of(owner);
    metadata.ifPresent(
        source -> {
          Set<X3DNode> seen = new HashSet<>();
          watch(source, false, seen, fields);
          watch(source.node(), "metadata", fields);
          source.metadata().ifPresent(inner -> watch(inner, true, seen, fields));
        });
    watched = List.copyOf(fields); // compact: a scene may have very many
    return metadata;
  }

  /** Stops listening. */
  void close() {
    if (registration != null) {
      registration.close();
      registration = null;
    }
    X3DFieldEventListener listener = onChange;
    if (listener != null) {
      watched.forEach(field -> FieldListeners.remove(field, listener));
      watched = List.of();
    }
  }

  private void watch(SaiMetadata source, boolean inner, Set<X3DNode> seen, List<X3DField> fields) {
    if (seen.add(source.node())) {
      watch(source.node(), "value", fields);
      if (!source.isSet() || inner) { // the name of a set of choices has no meaning
        watch(source.node(), "name", fields);
      }
      source.children().forEach(child -> watch(child, inner, seen, fields));
    }
  }

  private void watch(X3DNode node, String fieldName, List<X3DField> fields) {
    X3DField field = node.getField(fieldName);
    field.addX3DEventListener(onChange);
    fields.add(field);
  }
}
