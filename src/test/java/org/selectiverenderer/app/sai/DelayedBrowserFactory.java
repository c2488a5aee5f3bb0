package org.selectiverenderer.app.sai;

import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.Proxy;
import java.net.InetAddress;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.sai.EmbeddedBrowserFactory;
import org.selectiverenderer.testing.Eventually;
import org.web3d.x3d.sai.BrowserEvent;
import org.web3d.x3d.sai.BrowserFactoryImpl;
import org.web3d.x3d.sai.BrowserListener;
import org.web3d.x3d.sai.ExternalBrowser;
import org.web3d.x3d.sai.NotSupportedException;
import org.web3d.x3d.sai.X3DComponent;

/**
 * Makes browsers that say late that they show another world, and by a thread of their own, as Xj3D
 * does: when the thread that brought the world has nothing else to do than to wait for it. Prints a
 * line if that thread works with the world before.
 */
public final class DelayedBrowserFactory implements BrowserFactoryImpl {
  static final String TOO_EARLY = "the world was used before it was shown";

  @Override
  public X3DComponent createComponent(Map<String, Object> parameters) {
    X3DComponent embedded = new EmbeddedBrowserFactory().createComponent(parameters);
    ExternalBrowser late = new Late(embedded.getBrowser()).browser();
    return standIn(
        X3DComponent.class,
        (method, arguments) ->
            method.getName().equals("getBrowser") ? late : call(embedded, method, arguments));
  }

  @Override
  public ExternalBrowser getBrowser(InetAddress address, int port) {
    throw new NotSupportedException("browsers on other machines");
  }

  private static final class Late {
    private final ExternalBrowser embedded;
    private volatile @Nullable Thread waiting;
    private volatile boolean used;

    Late(ExternalBrowser embedded) {
      this.embedded = embedded;
    }

    ExternalBrowser browser() {
      return standIn(ExternalBrowser.class, this::answer);
    }

    private @Nullable Object answer(Method method, Object[] arguments) throws Throwable {
      switch (method.getName()) {
        case "addBrowserListener" -> {
          BrowserListener listener = (BrowserListener) arguments[0];
          embedded.addBrowserListener(event -> told(listener, event));
          return null;
        }
        case "replaceWorld" -> {
          Object nothing = call(embedded, method, arguments);
          waiting = Thread.currentThread();
          return nothing;
        }
        default -> {
          used |= Thread.currentThread() == waiting;
          return call(embedded, method, arguments);
        }
      }
    }

    private void told(BrowserListener listener, BrowserEvent event) {
      if (event.getID() != BrowserEvent.INITIALIZED) {
        listener.browserChanged(event);
        return;
      }
      Thread teller =
          new Thread(
              () -> {
                awaitIdle();
                if (used) {
                  System.out.println(TOO_EARLY);
                }
                listener.browserChanged(event);
              },
              "late-teller");
      teller.setDaemon(true);
      teller.start();
    }

    private void awaitIdle() {
      Eventually.await(
          "the thread that brought the world to wait for it",
          () -> {
            Thread thread = waiting;
            return used || thread != null && thread.getState() == Thread.State.TIMED_WAITING;
          });
    }
  }

  @FunctionalInterface
  private interface Answer {
    @Nullable Object to(Method method, Object[] arguments) throws Throwable;
  }

  private static <T> T standIn(Class<T> type, Answer answer) {
    return type.cast(
        Proxy.newProxyInstance(
            type.getClassLoader(),
            new Class<?>[] {type},
            (proxy, method, arguments) -> answer.to(method, arguments)));
  }

  private static @Nullable Object call(Object object, Method method, Object[] arguments)
      throws Throwable {
    try {
      return method.invoke(object, arguments);
    } catch (InvocationTargetException e) {
      throw e.getCause();
    }
  }
}
