package org.selectiverenderer.runtime.scene;

import java.util.ArrayDeque;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.Problems;

/**
 * The event cascade (X3D 4.0, 4.4.8.3): carries events along routes until no more are sent, all
 * with one time stamp, then calls listeners, whose own events cascade in turn.
 *
 * <p>Each event that begins outside (a sensor's, an application's, a listener's) is a first event
 * of its own and is carried to its end before the next one begins, so that none is lost and the
 * last one sent wins. Within it, order is first in, first out, and fan-out is in the order of the
 * routes: the same input gives the same events. A field takes one event in answer to the same first
 * event; that ends loops, and where routes meet again the first arrival counts (X3D 4.0, 4.4.8.4).
 */
public final class Cascade {
  /** Listener calls in one run after which something is taken to be endless. */
  static final int MAX_NOTIFICATIONS = 1_000_000;

  private record Delivery(Node to, int field, @Nullable Object value) {}

  private record First(Node node, int field, @Nullable Object value, boolean input) {}

  private record Notification(
      FieldListener listener, Node node, int field, @Nullable Object value) {}

  private final ArrayDeque<Delivery> deliveries = new ArrayDeque<>();
  private final ArrayDeque<First> waiting = new ArrayDeque<>();
  private final ArrayDeque<Notification> notifications = new ArrayDeque<>();
  private final Problems problems;
  private double time;
  private long id;
  private boolean carrying;
  private boolean running;

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

  /**
   * A first event: what an application sends to a field. It is carried along the routes at once, or
   * after the first event that is being carried; listeners hear of it in {@link #run()}.
   */
  public void send(Node node, int field, @Nullable Object value) {
    begin(node, field, value, true);
  }

  /** Sends a value from an output of a node, as a first event. */
  public void emit(Node node, int field, @Nullable Object value) {
    begin(node, field, value, false);
  }

  private void begin(Node node, int field, @Nullable Object value, boolean input) {
    if (carrying) {
      waiting.add(new First(node, field, value, input));
      return;
    }
    carrying = true;
    try {
      carry(node, field, value, input);
      for (First next = waiting.poll(); next != null; next = waiting.poll()) {
        carry(next.node, next.field, next.value, next.input);
      }
    } finally {
      carrying = false;
      deliveries.clear();
      waiting.clear();
    }
  }

  private void carry(Node node, int field, @Nullable Object value, boolean input) {
    id++;
    if (input) {
      node.receive(node.type().fields().get(field), value, this);
    } else {
      node.emit(field, value, this);
    }
    for (Delivery next = deliveries.poll(); next != null; next = deliveries.poll()) {
      next.to.receive(next.to.type().fields().get(next.field), next.value, this);
    }
  }

  /** Whether a first event is being carried. */
  boolean carrying() {
    return carrying;
  }

  /** Numbers the first event that is being carried. */
  long id() {
    return id;
  }

  void deliver(Node to, int field, @Nullable Object value) {
    deliveries.add(new Delivery(to, field, value));
  }

  /**
   * Calls a listener in {@link #run()}, after those that wait already. For what is no event, but to
   * be heard as one: a file that has arrived.
   */
  public void notify(FieldListener listener, Node node, int field, @Nullable Object value) {
    notifications.add(new Notification(listener, node, field, value));
  }

  /**
   * Calls the listeners of everything that was sent, until they send no more. They hear the time
   * stamp of now: what was sent between two frames belongs to the one that delivers it. Should one
   * end in an error that {@link ApplicationCode} lets through, the rest are called in the next run.
   */
  public void run() {
    if (running) {
      return; // A listener asked for it; the run that called it goes on.
    }
    running = true;
    try {
      for (int calls = 0; !notifications.isEmpty(); calls++) {
        Notification next = notifications.remove();
        if (calls == MAX_NOTIFICATIONS) {
          notifications.clear();
          problems.error(
              next.node.location(), "listeners trigger each other endlessly; events were dropped");
          return;
        }
        call(next);
      }
    } finally {
      running = false;
    }
  }

  private void call(Notification next) {
    ApplicationCode.call(
        problems,
        next.node.location(),
        "a listener of " + next.node.type().fields().get(next.field).name(),
        () -> next.listener.fieldChanged(next.node, next.field, next.value, time));
  }
}
