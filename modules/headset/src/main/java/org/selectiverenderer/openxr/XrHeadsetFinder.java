package org.selectiverenderer.openxr;

import java.util.Locale;
import java.util.function.Consumer;

/** Finds the headset of this computer. */
public final class XrHeadsetFinder implements AutoCloseable {
  private final XrLoader loader;
  private final XrConnection connection;
  private boolean handed;

  private XrHeadsetFinder(XrLoader loader, XrConnection connection) {
    this.loader = loader;
    this.connection = connection;
  }

  /**
   * Connects to the runtime, before any window opens.
   *
   * @throws HeadsetUnavailableException with a message that says what is missing and what to do
   */
  public static XrHeadsetFinder begin() throws HeadsetUnavailableException {
    String system = System.getProperty("os.name").toLowerCase(Locale.ROOT);
    if (system.startsWith("mac")) {
      throw new HeadsetUnavailableException(
          "there is no OpenXR on macOS: --display openxr needs Linux or Windows");
    }
    return begin(new LwjglLoader());
  }

  static XrHeadsetFinder begin(XrLoader loader) throws HeadsetUnavailableException {
    return new XrHeadsetFinder(loader, XrConnection.open(loader));
  }

  /** Returns the headset's name. */
  public String headset() {
    return connection.headset();
  }

  /** Returns name and version of the runtime. */
  public String runtime() {
    return connection.runtime();
  }

  /** Returns whether the headset has an eye tracker that the runtime supports. */
  public boolean tracksEyes() {
    return connection.tracksEyes();
  }

  /** Returns the recommended size of an eye's picture. */
  public RecommendedImageSize size() {
    return connection.instance().pictures(connection.system()).get(0);
  }

  /**
   * Begins a session on the headset.
   *
   * @param binding of the OpenGL context that is current on this thread
   * @param news receives the headset's events, on this thread
   */
  public XrHeadset show(GraphicsBinding binding, Posture posture, Consumer<HeadsetEvent> news) {
    handed = true;
    return new XrHeadset(loader, connection, binding, posture, news, System::nanoTime);
  }

  /** Closes the connection, unless a session took it over. */
  @Override
  public void close() {
    if (!handed) {
      connection.close();
    }
  }
}
