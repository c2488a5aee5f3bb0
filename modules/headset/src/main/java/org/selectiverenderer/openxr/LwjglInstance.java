package org.selectiverenderer.openxr;

import static org.lwjgl.openxr.XR10.XR_ENVIRONMENT_BLEND_MODE_OPAQUE;
import static org.lwjgl.openxr.XR10.XR_FORM_FACTOR_HEAD_MOUNTED_DISPLAY;
import static org.lwjgl.openxr.XR10.XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO;
import static org.selectiverenderer.openxr.LwjglLoader.check;

import java.nio.IntBuffer;
import java.nio.LongBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import org.lwjgl.PointerBuffer;
import org.lwjgl.openxr.EXTUserPresence;
import org.lwjgl.openxr.KHRConvertTimespecTime;
import org.lwjgl.openxr.KHROpenGLEnable;
import org.lwjgl.openxr.KHRVisibilityMask;
import org.lwjgl.openxr.XR10;
import org.lwjgl.openxr.XrEventDataBuffer;
import org.lwjgl.openxr.XrEventDataReferenceSpaceChangePending;
import org.lwjgl.openxr.XrEventDataSessionStateChanged;
import org.lwjgl.openxr.XrEventDataUserPresenceChangedEXT;
import org.lwjgl.openxr.XrGraphicsBindingOpenGLWin32KHR;
import org.lwjgl.openxr.XrGraphicsBindingOpenGLXlibKHR;
import org.lwjgl.openxr.XrGraphicsRequirementsOpenGLKHR;
import org.lwjgl.openxr.XrInstanceProperties;
import org.lwjgl.openxr.XrSessionCreateInfo;
import org.lwjgl.openxr.XrSystemEyeGazeInteractionPropertiesEXT;
import org.lwjgl.openxr.XrSystemGetInfo;
import org.lwjgl.openxr.XrSystemProperties;
import org.lwjgl.openxr.XrViewConfigurationView;
import org.lwjgl.system.MemoryStack;
import org.lwjgl.system.MemoryUtil;

/** An instance of LWJGL's OpenXR: a connection to the runtime. */
final class LwjglInstance implements XrInstance {
  private static final int STEREO = XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO;

  private final org.lwjgl.openxr.XrInstance instance;

  LwjglInstance(org.lwjgl.openxr.XrInstance instance) {
    this.instance = instance;
  }

  @Override
  public String runtime() {
    try (MemoryStack stack = MemoryStack.stackPush()) {
      XrInstanceProperties found = XrInstanceProperties.calloc(stack).type$Default();
      check("GetInstanceProperties", XR10.xrGetInstanceProperties(instance, found));
      long version = found.runtimeVersion();
      return "%s %d.%d.%d"
          .formatted(
              found.runtimeNameString().split(" by ", 2)[0],
              version >>> 48,
              version >>> 32 & 0xffff,
              version & 0xffffffffL);
    }
  }

  @Override
  public long system() {
    try (MemoryStack stack = MemoryStack.stackPush()) {
      XrSystemGetInfo info =
          XrSystemGetInfo.calloc(stack)
              .type$Default()
              .formFactor(XR_FORM_FACTOR_HEAD_MOUNTED_DISPLAY);
      LongBuffer found = stack.mallocLong(1);
      check("GetSystem", XR10.xrGetSystem(instance, info, found));
      return found.get(0);
    }
  }

  @Override
  public SystemFacts facts(long system) {
    try (MemoryStack stack = MemoryStack.stackPush()) {
      XrSystemProperties found = XrSystemProperties.calloc(stack).type$Default();
      XrSystemEyeGazeInteractionPropertiesEXT gaze =
          XrSystemEyeGazeInteractionPropertiesEXT.calloc(stack).type$Default();
      if (instance.getCapabilities().XR_EXT_eye_gaze_interaction) {
        found.next(gaze.address());
      }
      check("GetSystemProperties", XR10.xrGetSystemProperties(instance, system, found));
      return new SystemFacts(
          found.systemNameString(),
          found.trackingProperties().positionTracking(),
          gaze.supportsEyeGazeInteraction());
    }
  }

  @Override
  public List<RecommendedImageSize> pictures(long system) {
    try (MemoryStack stack = MemoryStack.stackPush()) {
      IntBuffer count = stack.ints(2);
      XrViewConfigurationView.Buffer views = XrViewConfigurationView.calloc(2, stack);
      views.forEach(XrViewConfigurationView::type$Default);
      check(
          "EnumerateViewConfigurationViews",
          XR10.xrEnumerateViewConfigurationViews(instance, system, STEREO, count, views));
      List<RecommendedImageSize> pictures = new ArrayList<>();
      views.forEach(
          view ->
              pictures.add(
                  new RecommendedImageSize(
                      view.recommendedImageRectWidth(),
                      view.recommendedImageRectHeight(),
                      view.recommendedSwapchainSampleCount())));
      return pictures;
    }
  }

  @Override
  public int blendMode(long system) {
    String function = "EnumerateEnvironmentBlendModes";
    try (MemoryStack stack = MemoryStack.stackPush()) {
      IntBuffer count = stack.ints(0);
      check(function, XR10.xrEnumerateEnvironmentBlendModes(instance, system, STEREO, count, null));
      IntBuffer modes = stack.mallocInt(Math.max(1, count.get(0)));
      check(
          function, XR10.xrEnumerateEnvironmentBlendModes(instance, system, STEREO, count, modes));
      return count.get(0) > 0 ? modes.get(0) : XR_ENVIRONMENT_BLEND_MODE_OPAQUE;
    }
  }

  @Override
  public XrSession session(long system, GraphicsBinding binding) {
    try (MemoryStack stack = MemoryStack.stackPush()) {
      // Required before xrCreateSession (XR_KHR_opengl_enable).
      XrGraphicsRequirementsOpenGLKHR needs =
          XrGraphicsRequirementsOpenGLKHR.calloc(stack).type$Default();
      check(
          "GetOpenGLGraphicsRequirementsKHR",
          KHROpenGLEnable.xrGetOpenGLGraphicsRequirementsKHR(instance, system, needs));
      XrSessionCreateInfo info =
          XrSessionCreateInfo.calloc(stack)
              .type$Default()
              .systemId(system)
              .next(binding(binding, stack));
      PointerBuffer handle = stack.mallocPointer(1);
      check("CreateSession", XR10.xrCreateSession(instance, info, handle));
      return new LwjglSession(new org.lwjgl.openxr.XrSession(handle.get(0), instance));
    }
  }

  private static long binding(GraphicsBinding binding, MemoryStack stack) {
    if (binding instanceof GraphicsBinding.Xlib x) {
      return XrGraphicsBindingOpenGLXlibKHR.calloc(stack)
          .type$Default()
          .xDisplay(x.display())
          .visualid(x.visual())
          .glxFBConfig(x.fbConfig())
          .glxDrawable(x.drawable())
          .glxContext(x.context())
          .address();
    }
    GraphicsBinding.Windows windows = (GraphicsBinding.Windows) binding;
    return XrGraphicsBindingOpenGLWin32KHR.calloc(stack)
        .type$Default()
        .hDC(windows.device())
        .hGLRC(windows.context())
        .address();
  }

  @Override
  public Optional<XrEvent> poll() {
    try (MemoryStack stack = MemoryStack.stackPush()) {
      XrEventDataBuffer event = XrEventDataBuffer.calloc(stack).type$Default();
      int result = check("PollEvent", XR10.xrPollEvent(instance, event));
      return result == XR10.XR_EVENT_UNAVAILABLE ? Optional.empty() : Optional.of(event(event));
    }
  }

  private static XrEvent event(XrEventDataBuffer event) {
    long at = event.address();
    return switch (event.type()) {
      case XR10.XR_TYPE_EVENT_DATA_SESSION_STATE_CHANGED ->
          new XrEvent.State(SessionState.of(XrEventDataSessionStateChanged.create(at).state()));
      case XR10.XR_TYPE_EVENT_DATA_INSTANCE_LOSS_PENDING -> new XrEvent.InstanceLoss();
      case XR10.XR_TYPE_EVENT_DATA_REFERENCE_SPACE_CHANGE_PENDING ->
          XrEventDataReferenceSpaceChangePending.create(at).referenceSpaceType()
                  == XR10.XR_REFERENCE_SPACE_TYPE_VIEW
              ? new XrEvent.Other()
              : new XrEvent.Recentred();
      case XR10.XR_TYPE_EVENT_DATA_INTERACTION_PROFILE_CHANGED -> new XrEvent.ControllersChanged();
      case KHRVisibilityMask.XR_TYPE_EVENT_DATA_VISIBILITY_MASK_CHANGED_KHR ->
          new XrEvent.MaskChanged();
      case EXTUserPresence.XR_TYPE_EVENT_DATA_USER_PRESENCE_CHANGED_EXT ->
          new XrEvent.Presence(XrEventDataUserPresenceChangedEXT.create(at).isUserPresent());
      default -> new XrEvent.Other();
    };
  }

  @Override
  public OptionalLong now() {
    try (MemoryStack stack = MemoryStack.stackPush()) {
      // struct timespec of CLOCK_MONOTONIC, which Java's nanoTime reads on Linux.
      long nanos = System.nanoTime();
      LongBuffer timespec = stack.longs(nanos / 1_000_000_000, nanos % 1_000_000_000);
      LongBuffer time = stack.mallocLong(1);
      int result =
          KHRConvertTimespecTime.nxrConvertTimespecTimeToTimeKHR(
              instance, MemoryUtil.memAddress(timespec), MemoryUtil.memAddress(time));
      return result < 0 ? OptionalLong.empty() : OptionalLong.of(time.get(0));
    }
  }

  @Override
  public XrActionSystem inputs() {
    return new LwjglActionSystem(instance);
  }

  @Override
  public void close() {
    XR10.xrDestroyInstance(instance);
  }
}
