package org.selectiverenderer.runtime.scene;

import java.lang.invoke.VarHandle;
import java.util.Arrays;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.x3d.FieldAccess;
import org.selectiverenderer.x3d.FieldDefinition;
import org.selectiverenderer.x3d.Location;
import org.selectiverenderer.x3d.NodeType;
import org.selectiverenderer.x3d.NodeView;

/**
 * A node of a running scene: its field values, and who hears of their changes. As it stands it
 * keeps and passes on events of its inputOutput fields; a node type with a behaviour of its own
 * extends it (package {@code nodes}). Not thread-safe: it belongs to the thread that steps the
 * world.
 */
public class Node implements NodeView {
  private static final Route[] NO_ROUTES = {};
  private static final NodeObserver[] NO_OBSERVERS = {};
  private static final ListenerOfField[] NO_LISTENERS = {};

  private record Listening(int field, FieldListener listener) implements ListenerOfField {
    @Override
    public void fieldChanged(Node node, int index, @Nullable Object value, double time) {
      listener.fieldChanged(node, index, value, time);
    }
  }

  private final NodeType type;
  private final Location location;
  private @Nullable String name;
  private final @Nullable Object[] values;
  private Route[] routes = NO_ROUTES;
  private @Nullable NodeObserver[] observers = NO_OBSERVERS;
  private int observerCount;
  private ListenerOfField[] listeners = NO_LISTENERS;
  private long @Nullable [] sentIn;
  private @Nullable Object companion;
  private @Nullable Cascade sentBy;

  public Node(NodeType type, @Nullable String name, Location location) {
    this.type = type;
    this.name = name;
    this.location = location;
    this.values = new Object[type.fields().size()];
  }

  @Override
  public final NodeType type() {
    return type;
  }

  @Override
  public final @Nullable String name() {
    return name;
  }

  /** Gives the node another DEF name; only its scene does. */
  final void rename(@Nullable String newName) {
    name = newName;
  }

  @Override
  public final Location location() {
    return location;
  }

  @Override
  public final @Nullable Object value(int field) {
    Object value = values[field];
    return value != null ? value : type.fields().get(field).defaultValue();
  }

  /** The node in an SFNode field, or null. */
  @Override
  public @Nullable Node node(String field) {
    return (Node) value(field);
  }

  /** The nodes in an MFNode field. */
  @Override
  @SuppressWarnings("unchecked")
  public List<Node> nodes(String field) {
    return (List<Node>) value(field);
  }

  /** What another layer keeps of this node: its SAI object. Null until there is one. */
  public final @Nullable Object companion() {
    return companion;
  }

  public final void companion(@Nullable Object object) {
    companion = object;
  }

  /** Gives a field its value before the node is part of a world: no event is sent. */
  public final void init(int field, @Nullable Object value) {
    values[field] = value;
  }

  /**
   * An event arrives at a field. The base class keeps the value of an inputOutput field and sends
   * it on; it ignores inputOnly fields, which only mean something to a behaviour.
   *
   * @param value as {@link org.selectiverenderer.x3d.FieldType} represents it
   */
  protected void receive(FieldDefinition field, @Nullable Object value, Cascade cascade) {
    if (field.access() == FieldAccess.INPUT_OUTPUT) {
      emit(field.index(), value, cascade);
    }
  }

  /**
   * Keeps a field's new value, tells the observers and sends it along routes and to listeners.
   * Outside a cascade it begins one. A second event of a field in answer to the same first event is
   * dropped (see {@link Cascade}).
   */
  public final void emit(int field, @Nullable Object value, Cascade cascade) {
    if (!cascade.carrying()) {
      cascade.emit(this, field, value);
      return;
    }
    if (!firstIn(cascade, field)) {
      return;
    }
    // Other threads may read fields at any time: they must not see an array before its elements.
    VarHandle.releaseFence();
    values[field] = value;
    tellObservers(field);
    for (Route route : routes) {
      if (route.fromField() == field) {
        cascade.deliver(route.to(), route.toField(), value);
      }
    }
    for (ListenerOfField listener : listeners) {
      if (listener.field() == field) {
        cascade.notify(listener, this, field, value);
      }
    }
  }

  /** Makes observers look at a field again, without an event: what it leads to has changed. */
  public final void tellObservers(int field) {
    for (int i = 0; i < observerCount; i++) {
      observers[i].changed(this, field);
    }
  }

  /** Whether a field sends its first event in that cascade; from now on it has. */
  private boolean firstIn(Cascade cascade, int field) {
    if (sentIn == null || sentBy != cascade) {
      sentIn = new long[values.length];
      sentBy = cascade;
    }
    boolean first = sentIn[field] != cascade.id();
    sentIn[field] = cascade.id();
    return first;
  }

  /** Fan-out happens in the order in which routes were added. */
  final void addRoute(Route route) {
    routes = append(routes, route);
  }

  final void removeRoute(Route route) {
    routes = remove(routes, route);
  }

  /** Observers are told in the order in which they were added. */
  public final void addObserver(NodeObserver observer) {
    if (observerCount == observers.length) {
      // Doubled, since a node that is USEd in many places has as many observers.
      observers = Arrays.copyOf(observers, Math.max(1, 2 * observerCount));
    }
    observers[observerCount++] = observer;
  }

  public final void removeObserver(NodeObserver observer) {
    for (int i = 0; i < observerCount; i++) {
      if (observers[i].equals(observer)) {
        System.arraycopy(observers, i + 1, observers, i, observerCount - i - 1);
        observers[--observerCount] = null;
        return;
      }
    }
  }

  /** Listeners are called in the order in which they were added. */
  public final void addListener(int field, FieldListener listener) {
    listeners = append(listeners, ofField(field, listener));
  }

  public final void removeListener(int field, FieldListener listener) {
    listeners = remove(listeners, ofField(field, listener));
  }

  /** The first listener of a field, or null. */
  public final @Nullable FieldListener listener(int field) {
    for (ListenerOfField listener : listeners) {
      if (listener.field() == field) {
        return listener;
      }
    }
    return null;
  }

  private static ListenerOfField ofField(int field, FieldListener listener) {
    return listener instanceof ListenerOfField own && own.field() == field
        ? own
        : new Listening(field, listener);
  }

  private static <T> T[] append(T[] array, T element) {
    T[] longer = Arrays.copyOf(array, array.length + 1);
    longer[array.length] = element;
    return longer;
  }

  private static <T> T[] remove(T[] array, T element) {
    int at = Arrays.asList(array).indexOf(element);
    if (at < 0) {
      return array;
    }
    T[] shorter = Arrays.copyOf(array, array.length - 1);
    System.arraycopy(array, at + 1, shorter, at, array.length - at - 1);
    return shorter;
  }

  @Override
  public String toString() {
    return name == null ? type.name() : type.name() + " " + name;
  }
}
