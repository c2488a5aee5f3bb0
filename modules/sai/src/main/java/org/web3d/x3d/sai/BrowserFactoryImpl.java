package org.web3d.x3d.sai;

import java.net.InetAddress;
import java.net.UnknownHostException;
import java.util.Map;

/**
 * Makes browsers; {@link BrowserFactory} finds one and hands all requests on to it. An
 * implementation that is found by its class name needs a public constructor without parameters.
 *
 * <p>Applets are gone and their class is missing from JDK 26 on. The two methods that name it are
 * there so that programs and implementations of old still link; they refuse by default, so that a
 * new implementation need not name the class.
 */
public interface BrowserFactoryImpl {
  /**
   * A new browser within a window of the program.
   *
   * @param parameters wishes by name, which the implementation defines; may be empty
   * @throws NotSupportedException if the implementation has no such component
   */
  X3DComponent createComponent(Map<String, Object> parameters) throws NotSupportedException;

  /**
   * The browser on the web page of an applet.
   *
   * @throws NotSupportedException always, unless an implementation knows better
   */
  @SuppressWarnings("removal")
  default ExternalBrowser getBrowser(java.applet.Applet applet)
      throws NotSupportedException, NoSuchBrowserException, ConnectionException {
    throw new NotSupportedException("there are no browsers beside applets any more");
  }

  /**
   * A browser in a frame beside an applet.
   *
   * @param frameName the name of the frame
   * @param index which browser of the frame, from 0
   * @throws NotSupportedException always, unless an implementation knows better
   */
  @SuppressWarnings("removal")
  default ExternalBrowser getBrowser(java.applet.Applet applet, String frameName, int index)
      throws NotSupportedException, NoSuchBrowserException, ConnectionException {
    throw new NotSupportedException("there are no browsers beside applets any more");
  }

  /**
   * A browser in another process, perhaps on another machine.
   *
   * @throws NotSupportedException if the implementation reaches none
   * @throws NoSuchBrowserException if there is no browser there
   * @throws UnknownHostException if there is no such machine
   * @throws ConnectionException if the connection cannot be made
   */
  ExternalBrowser getBrowser(InetAddress address, int port)
      throws NotSupportedException,
          NoSuchBrowserException,
          UnknownHostException,
          ConnectionException;
}
