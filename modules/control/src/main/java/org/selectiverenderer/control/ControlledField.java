package org.selectiverenderer.control;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.schema.FieldLevel;
import org.selectiverenderer.schema.FieldQuality;
import org.selectiverenderer.schema.FieldReference;
import org.selectiverenderer.schema.SwitchSchemas;
import org.web3d.x3d.sai.X3DException;
import org.web3d.x3d.sai.X3DField;
import org.web3d.x3d.sai.X3DFieldEventListener;
import org.web3d.x3d.sai.X3DFieldTypes;
import org.web3d.x3d.sai.X3DNode;
import org.web3d.x3d.sai.grouping.Switch;

/** A field whose value is a quality of an object. */
final class ControlledField implements ControlledChoice {
  /** The level of a field with another value than the levels have. */
  static final int NONE = -1;

  /** Receives the values that somebody else has set. */
  interface LevelListener {
    /**
     * Somebody else has set the field.
     *
     * @param from the level before
     * @param time stamp in seconds
     */
    void changed(ControlledField field, int from, double time);
  }

  private final VersionedObject object;
  private final FieldQuality quality;
  private final X3DNode owner;
  private final X3DField field;
  private final List<SaiFieldValue> values;
  private final X3DFieldEventListener onValue;
  private int shown;

  private ControlledField(
      VersionedObject object,
      FieldQuality quality,
      X3DNode owner,
      X3DField field,
      List<SaiFieldValue> values,
      ListenerLock turn,
      LevelListener listener) {
    this.object = object;
    this.quality = quality;
    this.owner = owner;
    this.field = field;
    this.values = List.copyOf(values);
    this.onValue = event -> turn.take(() -> valueChanged(event.getTime(), listener));
    shown = present();
    field.addX3DEventListener(onValue);
  }

  /**
   * Finds the field of a quality in the scene.
   *
   * @param scope the file of the object's Switch
   * @param problem receives what is wrong; the field is then left as it is
   */
  static Optional<ControlledField> find(
      VersionedObject object,
      SceneScope scope,
      FieldQuality quality,
      ListenerLock turn,
      LevelListener listener,
      Consumer<String> problem) {
    Supplier<String> what = () -> quality.quality().spelling() + " of " + quality.target();
    X3DNode node = node(scope, quality.target());
    if (node == null) {
      problem.accept(
          "%s cannot be chosen: the file has no node with the DEF name %s"
              .formatted(what.get(), quality.target().node()));
      return Optional.empty();
    }
    X3DField field = field(node, quality.target().field());
    if (field == null) {
      problem.accept(
          "%s cannot be chosen: %s %s has no inputOutput field %s"
              .formatted(
                  what.get(),
                  node.getNodeName(),
                  quality.target().node(),
                  quality.target().field()));
      return Optional.empty();
    }
    if (!SaiFieldValue.supports(field)) {
      problem.accept(
          "%s cannot be chosen: the field is of none of the types %s"
              .formatted(what.get(), String.join(", ", FieldQuality.TYPES)));
      return Optional.empty();
    }
    List<SaiFieldValue> values = new ArrayList<>();
    for (FieldLevel level : quality.levels()) {
      Optional<SaiFieldValue> value = SaiFieldValue.of(field, level.values());
      if (value.isEmpty()) {
        problem.accept(
            "%s cannot be chosen: \"%s\" is no value of the field"
                .formatted(what.get(), String.join(" ", level.values())));
        return Optional.empty();
      }
      values.add(value.get());
    }
    return Optional.of(new ControlledField(object, quality, node, field, values, turn, listener));
  }

  private static @Nullable X3DNode node(SceneScope scope, FieldReference target) {
    try {
      return scope.named(target.node());
    } catch (X3DException e) {
      return null; // there is none
    }
  }

  private static @Nullable X3DField field(X3DNode node, String name) {
    try {
      X3DField field = node.getField(name);
      return field != null && field.getDefinition().getAccessType() == X3DFieldTypes.INPUT_OUTPUT
          ? field
          : null;
    } catch (X3DException e) {
      return null; // there is none
    }
  }

  /** Returns the level whose value the field has, or {@link #NONE}. */
  private int present() {
    for (int level = 0; level < values.size(); level++) {
      if (values.get(level).isThere()) {
        return level;
      }
    }
    return NONE;
  }

  private void valueChanged(double time, LevelListener listener) {
    if (shown != NONE && values.get(shown).isThere()) {
      return;
    }
    int from = shown;
    shown = present();
    if (shown != from) {
      listener.changed(this, from, time);
    }
  }

  /** Returns whether the name of the quality's node is that of another node now. */
  boolean replaced(SceneScope scope) {
    X3DNode named = node(scope, quality.target());
    return named != null && !named.equals(owner);
  }

  FieldQuality quality() {
    return quality;
  }

  FieldReference target() {
    return quality.target();
  }

  VersionedObject object() {
    return object;
  }

  @Override
  public Optional<SwitchSchemas> schemas() {
    return Optional.of(quality.schemas());
  }

  @Override
  public int shown() {
    return shown;
  }

  @Override
  public Optional<ControlProblem> show(int level) {
    if (level == shown) {
      return Optional.empty();
    }
    shown = level;
    try {
      values.get(level).write();
      return Optional.empty();
    } catch (X3DException e) { // one disposed node must not stop the others
      return Optional.of(
          ControlProblem.warning(
              object.name(),
              object.node(),
              quality.target() + " cannot be set to level " + level + ": " + e.getMessage()));
    }
  }

  @Override
  public Switch node() {
    return object.node();
  }

  @Override
  public int child(int level) {
    return object.shown();
  }

  @Override
  public ControlEvent change(
      double time, int from, int to, ChoiceCause cause, Optional<SwitchVisibility> seen) {
    return new ControlEvent.FieldChange(
        time,
        object.name(),
        quality.quality(),
        quality.target().toString(),
        from,
        to,
        cause.schema(),
        seen);
  }

  /** Stops listening. */
  void close() {
    FieldListeners.remove(field, onValue);
  }
}
