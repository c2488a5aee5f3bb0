package org.selectiverenderer.app.window;

import java.awt.EventQueue;
import java.lang.reflect.InvocationTargetException;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Supplier;
import javax.swing.JFrame;

/** Opens a window on Swing's thread and blocks the caller's thread until the window is done. */
final class ModalWindowRunner {
  private ModalWindowRunner() {}

  /**
   * Opens a window, waits until it is done, and closes it.
   *
   * @param make makes the window, which runs the given callback once, when it is done
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

  /** Returns the result of a function that runs on Swing's thread. */
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
