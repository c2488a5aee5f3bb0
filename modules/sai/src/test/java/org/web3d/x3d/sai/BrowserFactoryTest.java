package org.web3d.x3d.sai;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.net.InetAddress;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class BrowserFactoryTest {
  private @TempDir Path classPath;
  private ClassLoader loaderBefore;

  /** Says that it was asked. */
  public static final class First implements BrowserFactoryImpl {
    @Override
    public X3DComponent createComponent(Map<String, Object> parameters) {
      throw new NotSupportedException("first");
    }

    @Override
    public ExternalBrowser getBrowser(InetAddress address, int port) {
      throw new NoSuchBrowserException("first");
    }
  }

  @BeforeEach
  void rememberTheSurroundings() {
    loaderBefore = Thread.currentThread().getContextClassLoader();
    System.clearProperty(FactoryLookup.PROPERTY);
  }

  @AfterEach
  void restoreTheSurroundings() {
    Thread.currentThread().setContextClassLoader(loaderBefore);
    System.clearProperty(FactoryLookup.PROPERTY);
  }

  private void file(String className) throws IOException {
    Files.writeString(
        classPath.resolve(FactoryLookup.FILE), FactoryLookup.PROPERTY + "=" + className + "\n");
    URL[] urls = {classPath.toUri().toURL()};
    Thread.currentThread().setContextClassLoader(new URLClassLoader(urls, loaderBefore));
  }

  @Test
  void theSystemPropertyNamesTheImplementation() throws IOException {
    file("no.such.Factory");
    System.setProperty(FactoryLookup.PROPERTY, " " + First.class.getName());

    assertThat(FactoryLookup.find()).isInstanceOf(First.class);
  }

  @Test
  void withoutThePropertyTheFileOnTheClassPathNamesIt() throws IOException {
    file(First.class.getName());

    assertThat(FactoryLookup.find()).isInstanceOf(First.class);
  }

  @Test
  void aMissingClassIsRefusedByName() {
    System.setProperty(FactoryLookup.PROPERTY, "no.such.Factory");

    assertThatThrownBy(FactoryLookup::find)
        .isInstanceOf(NotSupportedException.class)
        .hasMessageContaining("no.such.Factory")
        .hasCauseInstanceOf(ClassNotFoundException.class);
  }

  @Test
  void aClassOfAnotherKindIsRefused() {
    System.setProperty(FactoryLookup.PROPERTY, "java.lang.String");

    assertThatThrownBy(FactoryLookup::find)
        .isInstanceOf(NotSupportedException.class)
        .hasMessageContaining("java.lang.String");
  }

  @Test
  void theImplementationIsSetOnceAndThenKept() throws Exception {
    try (var sai = new IsolatedSai()) {
      sai.set(First.class);

      assertThat(sai.callCreate()).isEqualTo("NotSupportedException: first");
      assertThat(sai.set(First.class)).startsWith("X3DException: there is a browser factory");
    }
  }

  @Test
  void noImplementationIsNoArgument() throws Exception {
    try (var sai = new IsolatedSai()) {
      assertThat(sai.set(null)).startsWith("IllegalArgumentException");
    }
  }

  /** The classes of the SAI anew, since what {@link BrowserFactory} keeps is static. */
  private static final class IsolatedSai implements AutoCloseable {
    private final URLClassLoader loader;
    private final Class<?> factory;

    IsolatedSai() throws Exception {
      URL[] urls = {
        BrowserFactory.class.getProtectionDomain().getCodeSource().getLocation(),
        First.class.getProtectionDomain().getCodeSource().getLocation()
      };
      loader = new URLClassLoader(urls, ClassLoader.getPlatformClassLoader());
      factory = loader.loadClass(BrowserFactory.class.getName());
    }

    String set(Class<?> implementation) throws Exception {
      Class<?> type = loader.loadClass(BrowserFactoryImpl.class.getName());
      Object instance =
          implementation == null
              ? null
              : loader.loadClass(implementation.getName()).getDeclaredConstructor().newInstance();
      return outcome("setBrowserFactoryImpl", type, instance);
    }

    String callCreate() throws Exception {
      return outcome("createX3DComponent", Map.class, Map.of());
    }

    private String outcome(String method, Class<?> type, Object argument) throws Exception {
      try {
        return String.valueOf(factory.getMethod(method, type).invoke(null, argument));
      } catch (java.lang.reflect.InvocationTargetException e) {
        Throwable cause = e.getCause();
        return cause.getClass().getSimpleName() + ": " + cause.getMessage();
      }
    }

    @Override
    public void close() throws IOException {
      loader.close();
    }
  }
}
