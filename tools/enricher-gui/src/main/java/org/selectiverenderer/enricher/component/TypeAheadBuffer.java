package org.selectiverenderer.enricher.component;

import java.awt.AWTEvent;
import java.awt.Component;
import java.awt.EventQueue;
import java.awt.Toolkit;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.awt.event.KeyEvent;
import java.util.ArrayDeque;
import java.util.Collections;
import java.util.Deque;
import java.util.IdentityHashMap;
import java.util.Optional;
import java.util.Set;
import javax.swing.Timer;

/**
 * Holds the keys that are typed while a dialog opens, and types them into its first field once that
 * has the focus. AWT alone gives them to whatever has the focus in the meantime, which may be the
 * button that Enter presses, and drops those that come while no window has the focus.
 *
 * <p>The held events go back into the event queue one at a time, and those that arrive meanwhile
 * wait behind them, so that their order stays and Tab among them moves the focus as usual.
 */
final class TypeAheadBuffer {
  /** Most events that are held; a typed letter is three. */
  private static final int MOST = 600;

  /** How long the field may take to get the focus, until keys go where AWT sends them. */
  private static final int PATIENCE_MILLISECONDS = 5_000;

  private final Component field;
  private final Queue queue;

  /** The pressed key that opened the dialog, whose letter is still to come; empty for none. */
  private Optional<KeyEvent> opener;

  private final Deque<KeyEvent> held = new ArrayDeque<>();
  private final Set<KeyEvent> released = Collections.newSetFromMap(new IdentityHashMap<>());
  private final Timer patience = new Timer(PATIENCE_MILLISECONDS, event -> release());
  private final FocusAdapter focused =
      new FocusAdapter() {
        @Override
        public void focusGained(FocusEvent event) {
          release();
        }
      };
  private boolean releasing;

  private TypeAheadBuffer(Component field) {
    this.field = field;
    opener =
        Optional.ofNullable(EventQueue.getCurrentEvent())
            .filter(event -> event.getID() == KeyEvent.KEY_PRESSED)
            .map(KeyEvent.class::cast);
    queue = Queue.installed(); // a new one knows no current event
  }

  /** Begins to hold keys for a field that is about to be shown. */
  static TypeAheadBuffer holdFor(Component field) {
    TypeAheadBuffer buffer = new TypeAheadBuffer(field);
    buffer.queue.buffers.push(buffer);
    field.addFocusListener(buffer.focused);
    buffer.patience.setRepeats(false);
    buffer.patience.start();
    return buffer;
  }

  /** Ends the holding; keys that the dialog did not get go to the window that has the focus. */
  void end() {
    release();
  }

  /** Whether an event is held, or belongs to the key that opened the dialog and types nothing. */
  private boolean takes(KeyEvent event) {
    if (released.remove(event)) {
      return false;
    }
    if (!ofOpener(event)) {
      held.add(event);
      if (held.size() >= MOST) {
        release();
      }
    }
    return true;
  }

  private boolean ofOpener(KeyEvent event) {
    boolean typed = event.getID() == KeyEvent.KEY_TYPED;
    boolean its = typed && opener.filter(key -> key.getKeyChar() == event.getKeyChar()).isPresent();
    if (typed || event.getID() == KeyEvent.KEY_PRESSED) {
      opener = Optional.empty();
    }
    return its;
  }

  private void release() {
    patience.stop();
    field.removeFocusListener(focused);
    if (!releasing) {
      releasing = true;
      releaseNext();
    }
  }

  private void releaseNext() {
    KeyEvent next = held.poll();
    if (next == null) {
      queue.buffers.remove(this);
      return;
    }
    released.add(next);
    queue.postEvent(next);
    EventQueue.invokeLater(this::releaseNext);
  }

  /**
   * The event queue of the program since its first dialog; the keys that arrive while dialogs open
   * go to the buffer of the last one.
   */
  private static final class Queue extends EventQueue {
    private final Deque<TypeAheadBuffer> buffers = new ArrayDeque<>();

    /** Returns the queue, which stays installed: queues can only be removed in their order. */
    static Queue installed() {
      EventQueue now = Toolkit.getDefaultToolkit().getSystemEventQueue();
      if (now instanceof Queue already) {
        return already;
      }
      Queue made = new Queue();
      now.push(made);
      return made;
    }

    @Override
    protected void dispatchEvent(AWTEvent event) {
      TypeAheadBuffer last = buffers.peek();
      if (last == null || !(event instanceof KeyEvent key) || !last.takes(key)) {
        super.dispatchEvent(event);
      }
    }
  }
}
