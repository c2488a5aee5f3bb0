package org.selectiverenderer.openxr;

import java.util.Locale;
import java.util.function.Consumer;

/** Finds the headset of this computer. */
public final class XrSearch implements AutoCloseable {
  private final XrLoader loader;
  private final XrConnection connection;
  private boolean handed;

  private XrSearch(XrLoader loader, XrConnection connection) {
    this.loader = loader;
    this.connection = connection;
  }

  /**
   * Connects to the runtime, before any window opens.
   *
   * @throws HeadsetUnavailableException with a sentence that says what is missing and what to do
   */
  public static XrSearch begin() throws HeadsetUnavailableException {
    String system = System.getProperty("os.name").toLowerCase(Locale.ROOT);
    if (system.startsWith("mac")) {
      throw new HeadsetUnavailableException(
          "there is no OpenXR on macOS: --display openxr needs Linux or Windows");
    }
    return begin(new LwjglLoader());
  }

  static XrSearch begin(XrLoader loader) throws HeadsetUnavailableException {
    return new XrSearch(loader, XrConnection.open(loader));
  }

  /** The headset's name. */
  public String headset() {
    return connection.headset();
  }

  /** The runtime's name and version. */
  public String runtime() {
    return connection.runtime();
  }

  /** Whether the headset has an eye tracker, and the runtime tells where the eyes look. */
  public boolean tracksEyes() {
    return connection.tracksEyes();
  }

  /** What it recommends for an eye's picture. */
  public PictureSize size() {
    return connection.instance().pictures(connection.system()).get(0);
  }

  /**
   * Begins to show pictures.
   *
   * @param binding of the OpenGL context that is current on this thread
   * @param news hears what becomes of it, on this thread
   */
  public XrHeadset show(GraphicsBinding binding, Posture posture, Consumer<HeadsetNews> news) {
    handed = true;
    return new XrHeadset(loader, connection, binding, posture, news, System::nanoTime);
  }

  /** Lets go of the runtime if nothing was shown. */
  @Override
  public void close() {
    if (!handed) {
      connection.close();
    }
  }
}
