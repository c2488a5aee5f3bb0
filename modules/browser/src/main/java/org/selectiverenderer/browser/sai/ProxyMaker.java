package org.selectiverenderer.browser.sai;

import java.lang.reflect.Constructor;
import java.lang.reflect.InvocationHandler;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.Proxy;
import java.util.Arrays;
import org.jspecify.annotations.Nullable;

/** Makes the dynamic proxies of one list of interfaces, to which {@link SaiObject} is added. */
final class ProxyMaker {
  private final Class<?>[] interfaces;
  private volatile @Nullable Constructor<?> constructor;

  /**
   * @param ofSai interfaces of the SAI
   */
  ProxyMaker(Class<?>... ofSai) {
    interfaces = Arrays.copyOf(ofSai, ofSai.length + 1);
    interfaces[ofSai.length] = SaiObject.class;
  }

  /** Returns whether a method of a proxy asks for its handler. */
  static boolean asksForHandler(Method method) {
    return method.getDeclaringClass() == SaiObject.class;
  }

  Object make(InvocationHandler handler) {
    Constructor<?> known = constructor;
    try {
      if (known != null) {
        return known.newInstance(handler);
      }
      Object first =
          Proxy.newProxyInstance(SaiObject.class.getClassLoader(), interfaces, handler);
      constructor = first.getClass().getConstructor(InvocationHandler.class);
      return first;
    } catch (NoSuchMethodException
        | InstantiationException
        | IllegalAccessException
        | InvocationTargetException e) {
      throw new IllegalStateException(e); // Every proxy class has this public constructor.
    }
  }
}
