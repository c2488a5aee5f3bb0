package org.selectiverenderer.testing;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.channels.FileChannel;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Objects;
import org.junit.jupiter.api.extension.BeforeAllCallback;
import org.junit.jupiter.api.extension.BeforeEachCallback;
import org.junit.jupiter.api.extension.ExtensionContext;
import org.junit.jupiter.api.extension.ExtensionContext.Namespace;

/**
 * Keeps the screen for one test class, or for one test, at a time: {@link ShowsWindows}. Processes
 * agree by a lock on a file, which ends with a process however that ends.
 */
public final class ScreenLockExtension implements BeforeAllCallback, BeforeEachCallback {
  private static final Namespace NAMESPACE = Namespace.create(ScreenLockExtension.class);

  @Override
  public void beforeAll(ExtensionContext context) {
    take(context);
  }

  @Override
  public void beforeEach(ExtensionContext context) {
    take(context); // Unless its class has it.
  }

  /** Whether a test, or its class, has the screen. */
  public static boolean held(ExtensionContext test) {
    return test.getStore(NAMESPACE).get(Held.class) != null;
  }

  private static void take(ExtensionContext context) {
    context
        .getStore(NAMESPACE)
        .computeIfAbsent(
            Held.class,
            key -> Held.wait(file(Objects.requireNonNullElse(System.getenv("DISPLAY"), ""))),
            Held.class);
  }

  /** The same for all who show windows on one display. */
  private static Path file(String display) {
    return Path.of(
        System.getProperty("java.io.tmpdir"),
        "selective-renderer-tests%s.lock".formatted(display.replaceAll("[^A-Za-z0-9.]+", "-")));
  }

  /** Closed by JUnit at the end of the class or test. */
  record Held(FileChannel channel) implements AutoCloseable {
    static Held wait(Path file) {
      try {
        FileChannel channel =
            FileChannel.open(file, StandardOpenOption.CREATE, StandardOpenOption.WRITE);
        channel.lock();
        return new Held(channel);
      } catch (IOException e) {
        throw new UncheckedIOException(e);
      }
    }

    @Override
    public void close() throws IOException {
      channel.close();
    }
  }
}
