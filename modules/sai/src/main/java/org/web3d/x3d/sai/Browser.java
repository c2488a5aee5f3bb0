package org.web3d.x3d.sai;

import java.io.IOException;
import java.io.InputStream;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.w3c.dom.Node;

/**
 * What shows a scene. Every method throws {@link InvalidBrowserException} once the browser is
 * disposed of.
 */
public interface Browser {
  /** The name of the browser. */
  String getName() throws InvalidBrowserException;

  /** The version of the browser. */
  String getVersion() throws InvalidBrowserException;

  /** The profiles that the browser supports. */
  ProfileInfo[] getSupportedProfiles() throws InvalidBrowserException;

  /**
   * The profile of that name, for example {@code Immersive}.
   *
   * @throws NotSupportedException if the browser does not support it
   */
  ProfileInfo getProfile(String name) throws InvalidBrowserException, NotSupportedException;

  /** The components that the browser supports, each at its highest level. */
  ComponentInfo[] getSupportedComponents() throws InvalidBrowserException;

  /**
   * The component of that name at that level, for example {@code Grouping} at 2.
   *
   * @throws NotSupportedException if the browser does not support it
   */
  ComponentInfo getComponentInfo(String name, int level)
      throws InvalidBrowserException, NotSupportedException;

  /** The scene that is shown. */
  X3DExecutionContext getExecutionContext() throws InvalidBrowserException;

  /**
   * A new empty scene.
   *
   * @param components further components beside those of the profile; null for none
   * @throws IllegalArgumentException if the browser does not support them
   */
  X3DScene createScene(ProfileInfo profile, ComponentInfo @Nullable [] components)
      throws InvalidBrowserException, IllegalArgumentException;

  /** How fast the viewer moves, in metres per second in the coordinates of the viewpoint. */
  float getCurrentSpeed() throws InvalidBrowserException;

  /** Frames per second at present. */
  float getCurrentFrameRate() throws InvalidBrowserException;

  /** Shows another scene in place of the present one. */
  void replaceWorld(X3DScene scene) throws InvalidBrowserException;

  /**
   * Shows the first scene of a list that can be loaded.
   *
   * @param url addresses, the preferred one first
   * @param parameters for the browser, such as {@code target}; null for none
   */
  void loadURL(String[] url, @Nullable Map<String, Object> parameters)
      throws InvalidBrowserException, InvalidURLException;

  /** The description that the browser shows, such as the title of its window. */
  String getDescription() throws InvalidBrowserException;

  /** Sets the description that the browser shows. */
  void setDescription(String description) throws InvalidBrowserException;

  /**
   * A scene from text; the encoding is found out from the text.
   *
   * @throws InvalidX3DException if the text is no X3D
   */
  X3DScene createX3DFromString(String text) throws InvalidBrowserException, InvalidX3DException;

  /**
   * A scene from a stream.
   *
   * @param baseUrl what relative addresses in the scene are relative to
   * @throws InvalidX3DException if the stream holds no X3D
   * @throws IOException if the stream cannot be read
   */
  X3DScene createX3DFromStream(String baseUrl, InputStream stream)
      throws InvalidBrowserException, InvalidX3DException, IOException;

  /**
   * A scene from the first address of a list that can be loaded.
   *
   * @throws InvalidURLException if none can be
   * @throws InvalidX3DException if it is no X3D
   */
  X3DScene createX3DFromURL(String[] url)
      throws InvalidBrowserException, InvalidURLException, InvalidX3DException;

  /**
   * A scene from a DOM document or element in the XML encoding.
   *
   * @throws InvalidDocumentException if the node is no X3D
   * @throws NotSupportedException if the browser does not read DOM documents
   */
  X3DScene importDocument(Node element)
      throws InvalidBrowserException, InvalidDocumentException, NotSupportedException;

  /** Writes a message to the console of the browser. */
  void print(Object message) throws InvalidBrowserException;

  /** Writes a message and the end of a line to the console of the browser. */
  void println(Object message) throws InvalidBrowserException;

  /** Binds the next viewpoint of the list; the first one after the last. */
  void nextViewpoint() throws InvalidBrowserException;

  /** Binds the next viewpoint of a layer. */
  void nextViewpoint(int layer) throws InvalidBrowserException;

  /** Binds the previous viewpoint of the list; the last one before the first. */
  void previousViewpoint() throws InvalidBrowserException;

  /** Binds the previous viewpoint of a layer. */
  void previousViewpoint(int layer) throws InvalidBrowserException;

  /** Binds the first viewpoint of the list. */
  void firstViewpoint() throws InvalidBrowserException;

  /** Binds the first viewpoint of a layer. */
  void firstViewpoint(int layer) throws InvalidBrowserException;

  /** Binds the last viewpoint of the list. */
  void lastViewpoint() throws InvalidBrowserException;

  /** Binds the last viewpoint of a layer. */
  void lastViewpoint(int layer) throws InvalidBrowserException;

  /**
   * What the renderer can do, by the property names of ISO/IEC 19775-2 (such as {@code
   * Antialiased}).
   */
  Map<String, Object> getRenderingProperties()
      throws InvalidBrowserException, InvalidOperationTimingException;

  /** Which optional parts of the SAI the browser has, by the property names of ISO/IEC 19775-2. */
  Map<String, Object> getBrowserProperties()
      throws InvalidBrowserException, InvalidOperationTimingException;

  /**
   * Starts to draw, or goes on after a pause. Xj3D has this method and the next two in a type of
   * its own instead, where they throw: a program that is to run on Xj3D does not call them.
   */
  void startRender() throws InvalidBrowserException;

  /** Stops to draw and stops the time of the scene, until {@link #startRender()}. */
  void pauseRender() throws InvalidBrowserException;

  /** Ends drawing; {@link #startRender()} begins anew. */
  void stopRender() throws InvalidBrowserException;
}
