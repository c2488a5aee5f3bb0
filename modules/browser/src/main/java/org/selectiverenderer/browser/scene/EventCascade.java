package org.selectiverenderer.browser.scene;

import java.util.ArrayDeque;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.ProblemCollector;

/**
 * The event cascade (X3D 4.0, 4.4.8.3): carries events along routes until no more are sent, all
 * with one time stamp, then calls listeners, whose own events cascade in turn.
 *
 * <p>Each event from outside the cascade (of a sensor, an application or a listener) is an initial
 * event. It is carried to its end before the next one begins, so that none is lost and the last one
 * sent wins. Events that follow from an initial event are delivered first in, first out, and
 * fan-out is in the order of the routes: the same input gives the same events. A field accepts one
 * event per initial event; that breaks loops, and where routes converge the first arrival counts
 * (X3D 4.0, 4.4.8.4).
 */
public final class EventCascade {
  /** Number of listener calls in one run after which an endless loop is assumed. */
  static final int MAX_NOTIFICATIONS = 1_000_000;

  private record Delivery(Node to, int field, @Nullable Object value) {}

  private record First(Node node, int field, @Nullable Object value, boolean input) {}

  private record Notification(
      FieldListener listener, Node node, int field, @Nullable Object value) {}

  private final ArrayDeque<Delivery> deliveries = new ArrayDeque<>();
  private final ArrayDeque<First> waiting = new ArrayDeque<>();
  private final ArrayDeque<Notification> notifications = new ArrayDeque<>();
  private final ProblemCollector problems;
  private double time;
  private long id;
  private boolean carrying;
  private boolean running;

  public EventCascade(ProblemCollector problems) {
    this.problems = problems;
  }

  /** Returns the time stamp of the events now being sent, in seconds. */
  public double time() {
    return time;
  }

  /** Sets the time stamp for the events to come. */
  public void at(double seconds) {
    time = seconds;
  }

  /**
   * Sends a value to an input of a node, as an initial event. It is carried along the routes at
   * once, or after the initial event that is being carried; listeners are called in {@link #run()}.
   */
  public void send(Node node, int field, @Nullable Object value) {
    begin(node, field, value, true);
  }

  /** Sends a value from an output of a node, as an initial event. */
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

  /** Returns whether an initial event is being carried. */
  boolean carrying() {
    return carrying;
  }

  /** Returns the number of the initial event that is being carried. */
  long id() {
    return id;
  }

  void deliver(Node to, int field, @Nullable Object value) {
    deliveries.add(new Delivery(to, field, value));
  }

  /**
   * Queues a call of a listener for {@link #run()}, for occurrences that are not events but are
   * reported like one, such as the arrival of a file.
   */
  public void notify(FieldListener listener, Node node, int field, @Nullable Object value) {
    notifications.add(new Notification(listener, node, field, value));
  }

  /**
   * Calls the listeners of all events sent, until they send no more. They get the present time
   * stamp: events sent between two frames belong to the frame that delivers them. If a listener
   * ends in an error that {@link SafeListenerInvoker} lets through, the rest are called in the next
   * run.
   */
  public void run() {
    if (running) {
      return; // Called by a listener: the outer run continues.
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
    SafeListenerInvoker.call(
        problems,
        next.node.location(),
        () -> "a listener of " + next.node.type().fields().get(next.field).name(),
        () -> next.listener.fieldChanged(next.node, next.field, next.value, time));
  }
}
