package org.selectiverenderer.experiment.window;

import java.awt.EventQueue;
import java.lang.reflect.InvocationTargetException;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Supplier;
import javax.swing.JFrame;

/** Opens a window on Swing's thread and waits on the caller's until the window has an answer. */
final class Waiting {
  private Waiting() {}

  /**
   * Opens, waits, closes.
   *
   * @param make makes the window; it is to call what it is given once, when it is done
   */
  static void on(Function<Runnable, JFrame> make) {
    CountDownLatch done = new CountDownLatch(1);
    JFrame frame = onSwing(() -> make.apply(done::countDown));
    onSwing(
        () -> {
          frame.setVisible(true);
          return frame;
        });
    try {
      done.await();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } finally {
      EventQueue.invokeLater(frame::dispose);
    }
  }

  /** Makes something on Swing's thread. */
  static <T> T onSwing(Supplier<T> make) {
    Holder<T> holder = new Holder<>();
    try {
      EventQueue.invokeAndWait(() -> holder.accept(make.get()));
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IllegalStateException(e);
    } catch (InvocationTargetException e) {
      throw new IllegalStateException(e.getCause());
    }
    return holder.get();
  }

  private static final class Holder<T> implements Consumer<T>, Supplier<T> {
    private List<T> value = List.of();

    @Override
    public synchronized void accept(T made) {
      value = List.of(made);
    }

    @Override
    public synchronized T get() {
      return value.get(0);
    }
  }
}
