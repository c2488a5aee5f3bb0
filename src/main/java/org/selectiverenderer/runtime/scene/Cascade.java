package org.selectiverenderer.runtime.scene;

import java.util.ArrayDeque;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.x3d.Problems;

/**
 * The event cascade (X3D 4.0, 4.4.8.3): carries events along routes until no more are sent, all
 * with one time stamp, then calls listeners, whose own events cascade in turn.
 *
 * <p>Order is first in, first out, and fan-out is in the order of the routes, so that the same
 * input gives the same events. A loop is broken where a field would send a second event in answer
 * to the same first event. Events that begin outside (a sensor, a listener that sets a field) are
 * each a first event of their own, so that none of them is lost.
 */
public final class Cascade {
  /** Listener calls in one run after which something is taken to be endless. */
  static final int MAX_NOTIFICATIONS = 1_000_000;

  private record Delivery(Node to, int field, @Nullable Object value, long id) {}

  private record Notification(
      FieldListener listener, Node node, int field, @Nullable Object value, double time) {}

  private final ArrayDeque<Delivery> deliveries = new ArrayDeque<>();
  private final ArrayDeque<Notification> notifications = new ArrayDeque<>();
  private final Problems problems;
  private double time;
  private long lastId;
  private long currentId;

  public Cascade(Problems problems) {
    this.problems = problems;
  }

  /** The time stamp of the events now being sent, in seconds. */
  public double time() {
    return time;
  }

  /** Sets the time stamp for the events to come. */
  public void at(double seconds) {
    time = seconds;
  }

  /** A first event: what an application or a sensor sends to a field. */
  public void send(Node node, int field, @Nullable Object value) {
    long outer = currentId;
    currentId = ++lastId;
    node.receive(node.type().fields().get(field), value, this);
    currentId = outer;
  }

  /** Sends a value from an output of a node, as a first event. */
  public void emit(Node node, int field, @Nullable Object value) {
    long outer = currentId;
    currentId = ++lastId;
    node.emit(field, value, this);
    currentId = outer;
  }

  boolean maySend(Node node, int field) {
    if (currentId == 0) {
      return node.firstIn(++lastId, field);
    }
    return node.firstIn(currentId, field);
  }

  void deliver(Node to, int field, @Nullable Object value) {
    deliveries.add(new Delivery(to, field, value, currentId));
  }

  void notify(FieldListener listener, Node node, int field, @Nullable Object value) {
    notifications.add(new Notification(listener, node, field, value, time));
  }

  /** Carries everything that was sent to its end. */
  public void run() {
    drain();
    for (int calls = 0; !notifications.isEmpty(); calls++) {
      Notification next = notifications.remove();
      if (calls == MAX_NOTIFICATIONS) {
        notifications.clear();
        problems.error(
            next.node.location(), "listeners answer each other without end; events were dropped");
        return;
      }
      call(next);
      drain();
    }
  }

  private void call(Notification next) {
    try {
      next.listener.fieldChanged(next.node, next.field, next.value, next.time);
    } catch (RuntimeException | LinkageError e) {
      problems.error(
          next.node.location(),
          "a listener of %s failed and was passed over: %s"
              .formatted(
                  next.node.type().fields().get(next.field).name(),
                  Optional.ofNullable(e.getMessage()).orElse(e.getClass().getSimpleName())));
    }
  }

  private void drain() {
    long outer = currentId;
    for (Delivery next = deliveries.poll(); next != null; next = deliveries.poll()) {
      currentId = next.id;
      next.to.receive(next.to.type().fields().get(next.field), next.value, this);
    }
    currentId = outer;
  }
}
