package org.selectiverenderer.browser.scene;

import java.lang.invoke.VarHandle;
import java.util.Arrays;
import java.util.List;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.x3d.catalogue.AccessType;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.catalogue.NodeView;
import org.selectiverenderer.x3d.field.PackedArray;
import org.selectiverenderer.x3d.read.ParsedNode;

/**
 * A node of a running scene: its field values with their routes, observers and listeners. This base
 * class stores and forwards the events of inputOutput fields; a node type with a behaviour of its
 * own extends it (package {@code nodes}). Not thread-safe: it belongs to the thread that steps the
 * world.
 */
public class Node implements NodeView {
  private static final Object[] ALL_DEFAULTS = {};

  private record Listening(int field, FieldListener listener) implements SingleFieldListener {
    @Override
    public void fieldChanged(Node node, int index, @Nullable Object value, double time) {
      listener.fieldChanged(node, index, value, time);
    }
  }

  /** The routes and listeners of a node, and what it needs to send events. */
  private static final class Connections {
    private static final Route[] NO_ROUTES = {};
    private static final SingleFieldListener[] NO_LISTENERS = {};

    @Nullable Route[] routes = NO_ROUTES;
    int routeCount;
    @Nullable SingleFieldListener[] listeners = NO_LISTENERS;
    int listenerCount;
    long @Nullable [] sentIn;
    @Nullable EventCascade sentBy;
    @Nullable PrototypeInstance face;
  }

  /** Several observers, or none after several. */
  private static final class ObserverList {
    @Nullable NodeObserver[] all;
    int count = 1;

    ObserverList(Object first) {
      all = new NodeObserver[] {(NodeObserver) first, null};
    }

    void remove(NodeObserver observer) {
      for (int i = 0; i < count; i++) {
        if (all[i].equals(observer)) {
          System.arraycopy(all, i + 1, all, i, count - i - 1);
          all[--count] = null;
          return;
        }
      }
    }
  }

  private final NodeType type;

  /** The {@link SourceLocation} or, while the node is like it, the {@link NodeTemplate}. */
  private Object origin;

  private @Nullable String name;

  /** The values; shared with other nodes, and perhaps shorter, until the first change. */
  private @Nullable Object[] values = ALL_DEFAULTS;

  private boolean sharing = true;
  private int changes;

  /** Null, one observer, or an {@link ObserverList}: most nodes have one. */
  private @Nullable Object observers;

  private @Nullable Object companion;

  /** Routes and listeners; null for most nodes, of which a scene may have millions. */
  private @Nullable Connections connections;

  public Node(NodeType type, @Nullable String name, SourceLocation location) {
    this.type = type;
    this.name = name;
    this.origin = location;
  }

  @Override
  public final NodeType type() {
    return type;
  }

  @Override
  public final @Nullable String name() {
    return name;
  }

  /** Changes the DEF name; only the scene calls this. */
  final void rename(@Nullable String newName) {
    name = newName;
  }

  @Override
  public final SourceLocation location() {
    return origin instanceof NodeTemplate template ? template.location() : (SourceLocation) origin;
  }

  @Override
  public final @Nullable Object value(int field) {
    @Nullable Object[] now = values;
    Object value = field < now.length ? PackedArray.read(now[field]) : null;
    if (value instanceof ParsedNode) {
      value = makeParts()[field];
    }
    return value != null ? value : type.defaultValue(field);
  }

  /** Returns the node in an SFNode field, or null. */
  @Override
  public @Nullable Node node(String field) {
    return (Node) value(field);
  }

  /** Returns the nodes in an MFNode field. */
  @Override
  @SuppressWarnings("unchecked")
  public List<Node> nodes(String field) {
    return (List<Node>) value(field);
  }

  /**
   * Returns the object that another software layer has attached to this node, its SAI object; null
   * until there is one.
   */
  public final @Nullable Object companion() {
    return companion;
  }

  public final void companion(@Nullable Object object) {
    companion = object;
  }

  /** Returns the outermost prototype instance whose body starts with this node, or null. */
  final @Nullable PrototypeInstance face() {
    return connections == null ? null : connections.face;
  }

  final void face(PrototypeInstance outermost) {
    connections().face = outermost;
  }

  private Connections connections() {
    if (connections == null) {
      connections = new Connections();
    }
    return connections;
  }

  /**
   * Sets the initial value of a field before the node is part of a world; no event is sent.
   *
   * @param value as {@link org.selectiverenderer.x3d.field.FieldType} represents it, or such an
   *     array packed
   */
  public final void init(int field, @Nullable Object value) {
    set(field, value);
  }

  /** Returns the template of the node; null without one and once one of its values has changed. */
  public final @Nullable NodeTemplate template() {
    return origin instanceof NodeTemplate template ? template : null;
  }

  /** Notes that the node is like all others of a template. */
  public final void template(NodeTemplate template) {
    origin = template;
  }

  /** Notes that the node is no longer like others of its template: a node in it has changed. */
  public final void dropTemplate() {
    if (partsDeferred()) {
      makeParts();
    }
    if (origin instanceof NodeTemplate template) {
      origin = template.location();
    }
  }

  /**
   * Sets the initial values of all fields before the node is part of a world.
   *
   * @param initial the values by field, null for the default; not to be changed afterwards, as
   *     nodes may share it. A {@link ParsedNode} stands for a node that the template makes when it
   *     is asked for
   */
  public final void init(@Nullable Object[] initial) {
    values = initial;
    sharing = true;
  }

  /**
   * Returns whether the nodes in this one are not made yet: in a copy of a Shape of a file they are
   * made when the first of them is asked for.
   */
  public final boolean partsDeferred() {
    return sharing && isDeferred(values);
  }

  private static boolean isDeferred(@Nullable Object[] values) {
    for (Object value : values) {
      if (value instanceof ParsedNode) {
        return true;
      }
    }
    return false;
  }

  /**
   * Makes the nodes in this one and returns the values with them. Any thread may be the first to
   * ask; all get the same nodes.
   */
  private synchronized @Nullable Object[] makeParts() {
    @Nullable Object[] now = values;
    if (!isDeferred(now)) {
      return now;
    }
    NodeTemplate template = (NodeTemplate) origin;
    NodeObserver watch = (part, field) -> tellOfPart();
    @Nullable Object[] own = Arrays.copyOf(now, type.fields().size());
    for (int i = 0; i < own.length; i++) {
      if (own[i] instanceof ParsedNode parsed) {
        Node part = template.make(parsed);
        NodeSubgraphCollector.withMetadata(part).forEach(each -> each.addObserver(watch));
        own[i] = part;
      }
    }
    VarHandle.releaseFence();
    values = own;
    sharing = false;
    return own;
  }

  private void tellOfPart() {
    Object now = observers;
    if (now instanceof ObserverList list) {
      for (int i = 0; i < list.count; i++) {
        list.all[i].partChanges(this);
      }
    } else if (now != null) {
      ((NodeObserver) now).partChanges(this);
    }
  }

  private void set(int field, @Nullable Object value) {
    dropTemplate();
    if (sharing) {
      @Nullable Object[] own = Arrays.copyOf(values, type.fields().size());
      own[field] = value;
      VarHandle.releaseFence();
      values = own;
      sharing = false;
    } else {
      values[field] = value;
    }
  }

  /**
   * Is called when an event arrives at a field. The base class stores the value of an inputOutput
   * field and forwards it. An inputOnly field such as set_coordIndex sets the field coordIndex,
   * which cannot change otherwise (X3D 4.0, 11.2.2.4); other inputOnly fields only affect
   * subclasses.
   *
   * @param value as {@link org.selectiverenderer.x3d.field.FieldType} represents it
   */
  protected void receive(FieldDefinition field, @Nullable Object value, EventCascade cascade) {
    if (field.access() == AccessType.INPUT_OUTPUT) {
      emit(field.index(), value, cascade);
    } else if (field.access() == AccessType.INPUT_ONLY && field.name().startsWith("set_")) {
      type.field(field.name().substring("set_".length()))
          .filter(set -> set.access() == AccessType.INITIALIZE_ONLY && set.type() == field.type())
          .ifPresent(set -> replace(set.index(), value));
    }
  }

  /** Replaces the value of a field that sends no events and notifies the observers. */
  final void replace(int field, @Nullable Object value) {
    VarHandle.releaseFence();
    set(field, value);
    tellObservers(field);
  }

  /**
   * Stores a field's new value, notifies the observers, and sends the value along routes and to
   * listeners. Outside a cascade this starts one. A second event of a field for the same initial
   * event is dropped (see {@link EventCascade}).
   *
   * @return whether the event was sent
   */
  public final boolean emit(int field, @Nullable Object value, EventCascade cascade) {
    if (!cascade.carrying()) {
      cascade.emit(this, field, value);
      return true;
    }
    if (!firstIn(cascade, field)) {
      return false;
    }
    // Other threads may read fields at any time and must not see an array before its elements.
    VarHandle.releaseFence();
    set(field, value);
    tellObservers(field);
    sendOn(connections(), field, value, cascade);
    return true;
  }

  private void sendOn(Connections to, int field, @Nullable Object value, EventCascade cascade) {
    // Elements added meanwhile lie beyond the count; removing one replaces the array.
    Route[] going = to.routes;
    for (int i = 0, count = to.routeCount; i < count; i++) {
      Route route = going[i];
      if (route.fromField() == field) {
        cascade.deliver(route.to(), route.toField(), value);
      }
    }
    SingleFieldListener[] hearing = to.listeners;
    for (int i = 0, count = to.listenerCount; i < count; i++) {
      SingleFieldListener listener = hearing[i];
      if (listener.field() == field) {
        cascade.notify(listener, this, field, value);
      }
    }
  }

  /**
   * Stores a derived value in a field and notifies the observers, without an event; for values that
   * are computed from other nodes, such as the deformed skin of a humanoid.
   */
  public final void derive(int field, Object value) {
    replace(field, value);
  }

  /**
   * Notifies the observers of a field without an event, because content that the field refers to
   * has changed.
   */
  public final void tellObservers(int field) {
    changes++;
    // An observer may add and remove observers.
    for (int i = 0; ; i++) {
      Object now = observers;
      if (now instanceof ObserverList list) {
        if (i >= list.count) {
          return;
        }
        list.all[i].changed(this, field);
      } else if (now == null || i > 0) {
        return;
      } else {
        ((NodeObserver) now).changed(this, field);
      }
    }
  }

  /** Returns how often any field has got a new value, observed or not. */
  public final int changes() {
    return changes;
  }

  /**
   * Returns whether a field sends its first event for the present initial event, and notes that it
   * has.
   */
  private boolean firstIn(EventCascade cascade, int field) {
    Connections sending = connections();
    long[] sentIn = sending.sentIn;
    if (sentIn == null || sending.sentBy != cascade) {
      sentIn = new long[type.fields().size()];
      sending.sentIn = sentIn;
      sending.sentBy = cascade;
    }
    boolean first = sentIn[field] != cascade.id();
    sentIn[field] = cascade.id();
    return first;
  }

  /** Fan-out happens in the order in which routes were added. */
  final void addRoute(Route route) {
    heardFrom(route.fromField());
    connect(route);
  }

  /** Adds a route that is no part of a scene. */
  final void connect(Route route) {
    Connections to = connections();
    to.routes = append(to.routes, to.routeCount++, route);
  }

  /**
   * Is called before a route or listener is added to a field; a subclass that forwards the events
   * of other nodes connects to them.
   */
  void heardFrom(int field) {}

  final void removeRoute(Route route) {
    Connections to = connections();
    int at = Arrays.asList(to.routes).indexOf(route);
    if (at >= 0) {
      to.routes = without(to.routes, at, to.routeCount--);
    }
  }

  /** Adds an observer; observers are notified in the order in which they were added. */
  public final void addObserver(NodeObserver observer) {
    Object now = observers;
    if (now == null) {
      observers = observer;
      return;
    }
    ObserverList list = now instanceof ObserverList several ? several : new ObserverList(now);
    list.all = append(list.all, list.count++, observer);
    observers = list;
  }

  public final void removeObserver(NodeObserver observer) {
    if (observers instanceof ObserverList list) {
      list.remove(observer);
    } else if (observer.equals(observers)) {
      observers = null;
    }
  }

  /** Returns the first observer that is of a class and satisfies a condition, or null. */
  public final <O extends NodeObserver> @Nullable O observer(
      Class<O> kind, Predicate<? super O> wanted) {
    Object now = observers;
    if (!(now instanceof ObserverList list)) {
      return kind.isInstance(now) && wanted.test(kind.cast(now)) ? kind.cast(now) : null;
    }
    for (int i = 0; i < list.count; i++) {
      if (kind.isInstance(list.all[i]) && wanted.test(kind.cast(list.all[i]))) {
        return kind.cast(list.all[i]);
      }
    }
    return null;
  }

  /** Adds a listener; listeners are called in the order in which they were added. */
  public final void addListener(int field, FieldListener listener) {
    heardFrom(field);
    Connections to = connections();
    to.listeners = append(to.listeners, to.listenerCount++, ofField(field, listener));
  }

  public final void removeListener(int field, FieldListener listener) {
    Connections to = connections();
    int at = Arrays.asList(to.listeners).indexOf(ofField(field, listener));
    if (at >= 0) {
      to.listeners = without(to.listeners, at, to.listenerCount--);
    }
  }

  /** Returns whether a field has a route or a listener. */
  public final boolean heard(int field) {
    Connections to = connections;
    if (to == null) {
      return false;
    }
    for (int i = 0; i < to.routeCount; i++) {
      if (to.routes[i].fromField() == field) {
        return true;
      }
    }
    return listener(field, SingleFieldListener.class, any -> true) != null;
  }

  /**
   * Returns the first listener of a field that is of a class and satisfies a condition, or null.
   */
  public final <L extends SingleFieldListener> @Nullable L listener(
      int field, Class<L> kind, Predicate<? super L> wanted) {
    Connections to = connections;
    if (to == null) {
      return null;
    }
    for (int i = 0; i < to.listenerCount; i++) {
      SingleFieldListener listener = to.listeners[i];
      if (listener.field() == field
          && kind.isInstance(listener)
          && wanted.test(kind.cast(listener))) {
        return kind.cast(listener);
      }
    }
    return null;
  }

  private static SingleFieldListener ofField(int field, FieldListener listener) {
    return listener instanceof SingleFieldListener own && own.field() == field
        ? own
        : new Listening(field, listener);
  }

  /**
   * Appends an element, doubling a full array, since a node may have very many routes, observers or
   * listeners.
   */
  private static <T> @Nullable T[] append(@Nullable T[] array, int count, T element) {
    @Nullable T[] longer =
        count == array.length ? Arrays.copyOf(array, Math.max(1, 2 * count)) : array;
    longer[count] = element;
    return longer;
  }

  private static <T> @Nullable T[] without(@Nullable T[] array, int at, int count) {
    @Nullable T[] shorter = Arrays.copyOf(array, array.length);
    System.arraycopy(array, at + 1, shorter, at, count - at - 1);
    shorter[count - 1] = null;
    return shorter;
  }

  @Override
  public String toString() {
    return name == null ? type.name() : type.name() + " " + name;
  }
}
