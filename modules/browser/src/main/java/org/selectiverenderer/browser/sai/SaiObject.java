package org.selectiverenderer.browser.sai;

/**
 * The interface that the dynamic proxies of this package have besides those of the SAI. It tells
 * their handler, and as it is not public their classes lie in this package, so that their
 * constructors can be called: {@link java.lang.reflect.Proxy} would look up the class each time,
 * and a scene may have hundreds of thousands of nodes.
 */
interface SaiObject {
  /** Returns the handler of the proxy's calls. */
  Object handler();
}
