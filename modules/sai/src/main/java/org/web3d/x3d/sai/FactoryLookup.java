package org.web3d.x3d.sai;

import java.io.IOException;
import java.io.InputStream;
import java.util.ArrayList;
import java.util.List;
import java.util.Properties;
import org.jspecify.annotations.Nullable;

/**
 * Finds the implementation of {@link BrowserFactory}: the system property, else {@code
 * x3d.properties} on the class path, else the embedded browser. Classes and resources are looked
 * for by the class loader of the thread, then by the one of the SAI.
 */
final class FactoryLookup {
  static final String PROPERTY = "x3d.sai.factory.class";
  static final String FILE = "x3d.properties";
  static final String DEFAULT = "org.selectiverenderer.browser.sai.EmbeddedBrowserFactory";

  private FactoryLookup() {}

  /**
   * A new implementation.
   *
   * @throws NotSupportedException if the class is missing, cannot be made or is of another kind
   */
  static BrowserFactoryImpl find() {
    String name = className();
    try {
      return load(name).asSubclass(BrowserFactoryImpl.class).getDeclaredConstructor().newInstance();
    } catch (ReflectiveOperationException | ClassCastException | LinkageError e) {
      throw refusal("the browser factory " + name + " cannot be used: " + e, e);
    }
  }

  private static String className() {
    String named = System.getProperty(PROPERTY);
    if (named == null) {
      named = fromFile();
    }
    return named == null || named.isBlank() ? DEFAULT : named.strip();
  }

  private static @Nullable String fromFile() {
    for (ClassLoader loader : loaders()) {
      try (InputStream in = loader.getResourceAsStream(FILE)) {
        if (in != null) {
          Properties properties = new Properties();
          properties.load(in);
          return properties.getProperty(PROPERTY);
        }
      } catch (IOException | IllegalArgumentException e) {
        throw refusal(FILE + " on the class path cannot be read: " + e, e);
      }
    }
    return null;
  }

  private static Class<?> load(String name) throws ClassNotFoundException {
    List<ClassLoader> loaders = loaders();
    for (ClassLoader loader : loaders.subList(0, loaders.size() - 1)) {
      try {
        return Class.forName(name, true, loader);
      } catch (ClassNotFoundException e) {
        continue; // the next one may know it; what the last one says counts
      }
    }
    return Class.forName(name, true, loaders.get(loaders.size() - 1));
  }

  private static List<ClassLoader> loaders() {
    List<ClassLoader> loaders = new ArrayList<>();
    ClassLoader ofThread = Thread.currentThread().getContextClassLoader();
    if (ofThread != null) {
      loaders.add(ofThread);
    }
    ClassLoader own = FactoryLookup.class.getClassLoader();
    loaders.add(own != null ? own : ClassLoader.getSystemClassLoader());
    return loaders;
  }

  private static NotSupportedException refusal(String message, Throwable cause) {
    NotSupportedException refusal = new NotSupportedException(message);
    refusal.initCause(cause);
    return refusal;
  }
}
