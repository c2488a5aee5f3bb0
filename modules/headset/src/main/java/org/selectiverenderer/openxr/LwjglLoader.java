package org.selectiverenderer.openxr;

import static org.lwjgl.openxr.XR10.XR_TYPE_EXTENSION_PROPERTIES;
import static org.lwjgl.openxr.XR10.XR_TYPE_INSTANCE_CREATE_INFO;
import static org.lwjgl.openxr.XR10.xrCreateInstance;
import static org.lwjgl.openxr.XR10.xrEnumerateInstanceExtensionProperties;

import java.nio.IntBuffer;
import java.util.LinkedHashSet;
import java.util.Set;
import org.lwjgl.PointerBuffer;
import org.lwjgl.openxr.XR10;
import org.lwjgl.openxr.XrExtensionProperties;
import org.lwjgl.openxr.XrInstanceCreateInfo;
import org.lwjgl.system.MemoryStack;
import org.selectiverenderer.base.natives.LwjglLibraries;

/** The OpenXR loader that LWJGL contains. Memory of a call is freed within the call. */
final class LwjglLoader implements XrLoader {
  private static final String NAME = "Selective Renderer";

  LwjglLoader() {
    LwjglLibraries.use(LwjglLoader.class, LwjglLibraries.Part.OPENXR);
    OpenXrLogSuppressor.silence();
  }

  /** Throws {@link XrResultException} for a result below 0; all other results are success codes. */
  static int check(String function, int result) {
    if (result < 0) {
      throw new XrResultException(function, result);
    }
    return result;
  }

  @Override
  public Set<String> extensions() {
    String function = "EnumerateInstanceExtensionProperties";
    try (MemoryStack stack = MemoryStack.stackPush()) {
      IntBuffer count = stack.mallocInt(1);
      check(function, xrEnumerateInstanceExtensionProperties((CharSequence) null, count, null));
      try (XrExtensionProperties.Buffer found = XrExtensionProperties.calloc(count.get(0))) {
        found.forEach(each -> each.type(XR_TYPE_EXTENSION_PROPERTIES));
        check(function, xrEnumerateInstanceExtensionProperties((CharSequence) null, count, found));
        Set<String> names = new LinkedHashSet<>();
        found.forEach(each -> names.add(each.extensionNameString()));
        return names;
      }
    }
  }

  @Override
  public XrInstance create(Set<String> enabled) {
    XrInstanceCreateInfo info = XrInstanceCreateInfo.calloc();
    try (MemoryStack stack = MemoryStack.stackPush()) {
      PointerBuffer names = stack.mallocPointer(enabled.size());
      enabled.forEach(name -> names.put(stack.UTF8(name)));
      info.type(XR_TYPE_INSTANCE_CREATE_INFO).enabledExtensionNames(names.flip());
      info.applicationInfo()
          .applicationName(stack.UTF8(NAME))
          .engineName(stack.UTF8(NAME))
          .applicationVersion(1)
          .engineVersion(1)
          .apiVersion(XR10.XR_API_VERSION_1_0);
      PointerBuffer handle = stack.mallocPointer(1);
      check("CreateInstance", xrCreateInstance(info, handle));
      return new LwjglInstance(new org.lwjgl.openxr.XrInstance(handle.get(0), info));
    } finally {
      info.free();
    }
  }
}
