package org.web3d.x3d.sai;

import java.net.InetAddress;
import java.net.UnknownHostException;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/**
 * Where a program gets a browser from. The implementation is chosen at the first request and kept:
 *
 * <ol>
 *   <li>the one given to {@link #setBrowserFactoryImpl};
 *   <li>the class that the system property {@code x3d.sai.factory.class} names;
 *   <li>the class that the same key in {@code x3d.properties} on the class path names;
 *   <li>the embedded browser of this program.
 * </ol>
 *
 * Setting the property is all that it takes to run on another browser. Thread-safe. The methods and
 * the state behind them are static because the standard has them so.
 *
 * <p>Applets are gone and their class is missing from JDK 26 on. The two methods that name it are
 * kept so that programs of old still link; on such a JDK this class works as long as nobody asks it
 * by reflection for its methods.
 */
public class BrowserFactory {
  private static @Nullable BrowserFactoryImpl factory;

  private BrowserFactory() {}

  /**
   * Gives the implementation; possible once, before the first request.
   *
   * @throws IllegalArgumentException if the implementation is null
   * @throws X3DException if there is an implementation already
   * @throws SecurityException if the program may not choose
   */
  public static synchronized void setBrowserFactoryImpl(BrowserFactoryImpl implementation)
      throws IllegalArgumentException, X3DException, SecurityException {
    if (implementation == null) {
      throw new IllegalArgumentException("a browser factory is needed, not null");
    }
    if (factory != null) {
      throw new X3DException("there is a browser factory already; it cannot be replaced");
    }
    factory = implementation;
  }

  /**
   * A new browser within a window of the program.
   *
   * @param parameters wishes by name, which the implementation defines; may be empty
   * @throws NotSupportedException if the implementation cannot be found or has no such component
   */
  public static X3DComponent createX3DComponent(Map<String, Object> parameters)
      throws NotSupportedException {
    return factory().createComponent(parameters);
  }

  /**
   * The browser on the web page of an applet.
   *
   * @throws NotSupportedException unless the implementation still knows applets
   */
  @SuppressWarnings("removal")
  public static ExternalBrowser getBrowser(java.applet.Applet applet)
      throws NotSupportedException, NoSuchBrowserException, ConnectionException {
    return factory().getBrowser(applet);
  }

  /**
   * A browser in a frame beside an applet.
   *
   * @param frameName the name of the frame
   * @param index which browser of the frame, from 0
   * @throws NotSupportedException unless the implementation still knows applets
   */
  @SuppressWarnings("removal")
  public static ExternalBrowser getBrowser(java.applet.Applet applet, String frameName, int index)
      throws NotSupportedException, NoSuchBrowserException, ConnectionException {
    return factory().getBrowser(applet, frameName, index);
  }

  /**
   * A browser in another process, perhaps on another machine.
   *
   * @throws NotSupportedException if the implementation reaches none
   * @throws NoSuchBrowserException if there is no browser there
   * @throws UnknownHostException if there is no such machine
   * @throws ConnectionException if the connection cannot be made
   */
  public static ExternalBrowser getBrowser(InetAddress address, int port)
      throws NotSupportedException,
          NoSuchBrowserException,
          UnknownHostException,
          ConnectionException {
    return factory().getBrowser(address, port);
  }

  private static synchronized BrowserFactoryImpl factory() {
    BrowserFactoryImpl chosen = factory;
    if (chosen == null) {
      chosen = FactoryLookup.find();
      factory = chosen;
    }
    return chosen;
  }
}
