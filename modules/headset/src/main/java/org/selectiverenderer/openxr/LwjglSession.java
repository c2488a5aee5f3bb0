package org.selectiverenderer.openxr;

import static org.lwjgl.openxr.XR10.XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO;
import static org.selectiverenderer.openxr.LwjglLoader.check;

import java.nio.IntBuffer;
import java.nio.LongBuffer;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.lwjgl.PointerBuffer;
import org.lwjgl.openxr.KHRVisibilityMask;
import org.lwjgl.openxr.XR10;
import org.lwjgl.openxr.XrCompositionLayerProjection;
import org.lwjgl.openxr.XrCompositionLayerProjectionView;
import org.lwjgl.openxr.XrFovf;
import org.lwjgl.openxr.XrFrameBeginInfo;
import org.lwjgl.openxr.XrFrameEndInfo;
import org.lwjgl.openxr.XrFrameState;
import org.lwjgl.openxr.XrFrameWaitInfo;
import org.lwjgl.openxr.XrPosef;
import org.lwjgl.openxr.XrReferenceSpaceCreateInfo;
import org.lwjgl.openxr.XrSessionBeginInfo;
import org.lwjgl.openxr.XrSpace;
import org.lwjgl.openxr.XrSpaceLocation;
import org.lwjgl.openxr.XrSwapchain;
import org.lwjgl.openxr.XrSwapchainCreateInfo;
import org.lwjgl.openxr.XrSwapchainImageAcquireInfo;
import org.lwjgl.openxr.XrSwapchainImageBaseHeader;
import org.lwjgl.openxr.XrSwapchainImageOpenGLKHR;
import org.lwjgl.openxr.XrSwapchainImageReleaseInfo;
import org.lwjgl.openxr.XrSwapchainImageWaitInfo;
import org.lwjgl.openxr.XrVector2f;
import org.lwjgl.openxr.XrView;
import org.lwjgl.openxr.XrViewLocateInfo;
import org.lwjgl.openxr.XrViewState;
import org.lwjgl.openxr.XrVisibilityMaskKHR;
import org.lwjgl.system.MemoryStack;
import org.lwjgl.system.MemoryUtil;

/** A session of LWJGL's OpenXR. Handles are passed as numbers. */
final class LwjglSession implements XrSession {
  private static final int STEREO = XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO;
  private static final long ORIENTATION = XR10.XR_SPACE_LOCATION_ORIENTATION_VALID_BIT;
  private static final long VOUCHED =
      ORIENTATION
          | XR10.XR_SPACE_LOCATION_ORIENTATION_TRACKED_BIT
          | XR10.XR_SPACE_LOCATION_POSITION_TRACKED_BIT;

  /**
   * Timeout of waiting for a swapchain texture in nanoseconds, after which the runtime counts as
   * hung.
   */
  private static final long PATIENCE = 2_000_000_000;

  private final org.lwjgl.openxr.XrSession session;
  private final Map<Long, XrSpace> spaces = new HashMap<>();
  private final Map<Long, XrSwapchain> swapchains = new HashMap<>();

  LwjglSession(org.lwjgl.openxr.XrSession session) {
    this.session = session;
  }

  org.lwjgl.openxr.XrSession handle() {
    return session;
  }

  /** Registers a space that was created elsewhere. */
  long known(XrSpace space) {
    spaces.put(space.address(), space);
    return space.address();
  }

  @Override
  public Set<SpaceKind> spaceKinds() {
    String function = "EnumerateReferenceSpaces";
    try (MemoryStack stack = MemoryStack.stackPush()) {
      IntBuffer count = stack.ints(0);
      check(function, XR10.xrEnumerateReferenceSpaces(session, count, null));
      IntBuffer found = stack.callocInt(Math.max(1, count.get(0)));
      check(function, XR10.xrEnumerateReferenceSpaces(session, count, found));
      Set<SpaceKind> kinds = EnumSet.noneOf(SpaceKind.class);
      for (SpaceKind kind : SpaceKind.values()) {
        for (int i = 0; i < found.capacity(); i++) {
          if (found.get(i) == kind.number()) {
            kinds.add(kind);
          }
        }
      }
      return kinds;
    }
  }

  @Override
  public long space(SpaceKind kind) {
    try (MemoryStack stack = MemoryStack.stackPush()) {
      XrReferenceSpaceCreateInfo info =
          XrReferenceSpaceCreateInfo.calloc(stack)
              .type$Default()
              .referenceSpaceType(kind.number())
              .poseInReferenceSpace(pose -> pose.orientation().w(1));
      PointerBuffer handle = stack.mallocPointer(1);
      check("CreateReferenceSpace", XR10.xrCreateReferenceSpace(session, info, handle));
      return known(new XrSpace(handle.get(0), session));
    }
  }

  @Override
  public Optional<XrPose> locate(long space, long in, long time) {
    return locate(space, in, time, ORIENTATION);
  }

  @Override
  public Optional<XrPose> tracked(long space, long in, long time) {
    return locate(space, in, time, VOUCHED);
  }

  private Optional<XrPose> locate(long space, long in, long time, long flags) {
    try (MemoryStack stack = MemoryStack.stackPush()) {
      XrSpaceLocation found = XrSpaceLocation.calloc(stack).type$Default();
      check("LocateSpace", XR10.xrLocateSpace(spaces.get(space), spaces.get(in), time, found));
      return (found.locationFlags() & flags) != flags
          ? Optional.empty()
          : Optional.of(pose(found.pose()));
    }
  }

  @Override
  public Optional<List<XrEyeView>> eyes(long in, long time) {
    try (MemoryStack stack = MemoryStack.stackPush()) {
      XrViewLocateInfo info =
          XrViewLocateInfo.calloc(stack)
              .type$Default()
              .viewConfigurationType(STEREO)
              .displayTime(time)
              .space(spaces.get(in));
      XrViewState state = XrViewState.calloc(stack).type$Default();
      IntBuffer count = stack.ints(2);
      XrView.Buffer views = XrView.calloc(2, stack);
      views.forEach(XrView::type$Default);
      check("LocateViews", XR10.xrLocateViews(session, info, state, count, views));
      if ((state.viewStateFlags() & XR10.XR_VIEW_STATE_ORIENTATION_VALID_BIT) == 0) {
        return Optional.empty();
      }
      List<XrEyeView> sights = new ArrayList<>();
      for (XrView view : views) {
        XrFovf field = view.fov();
        sights.add(
            new XrEyeView(
                pose(view.pose()),
                Math.tan(field.angleLeft()),
                Math.tan(field.angleRight()),
                Math.tan(field.angleDown()),
                Math.tan(field.angleUp())));
      }
      return Optional.of(sights);
    }
  }

  private static XrPose pose(XrPosef pose) {
    return new XrPose(
        new Vector3d(pose.position$().x(), pose.position$().y(), pose.position$().z()),
        new Quaterniond(
                pose.orientation().x(),
                pose.orientation().y(),
                pose.orientation().z(),
                pose.orientation().w())
            .normalize());
  }

  @Override
  public List<Integer> formats() {
    String function = "EnumerateSwapchainFormats";
    try (MemoryStack stack = MemoryStack.stackPush()) {
      IntBuffer count = stack.ints(0);
      check(function, XR10.xrEnumerateSwapchainFormats(session, count, null));
      LongBuffer found = stack.callocLong(Math.max(1, count.get(0)));
      check(function, XR10.xrEnumerateSwapchainFormats(session, count, found));
      List<Integer> formats = new ArrayList<>();
      for (int i = 0; i < count.get(0); i++) {
        formats.add((int) found.get(i));
      }
      return formats;
    }
  }

  @Override
  public long swapchain(int format, int width, int height) {
    try (MemoryStack stack = MemoryStack.stackPush()) {
      XrSwapchainCreateInfo info =
          XrSwapchainCreateInfo.calloc(stack)
              .type$Default()
              .usageFlags(
                  XR10.XR_SWAPCHAIN_USAGE_COLOR_ATTACHMENT_BIT
                      | XR10.XR_SWAPCHAIN_USAGE_SAMPLED_BIT)
              .format(format)
              .sampleCount(1)
              .width(width)
              .height(height)
              .faceCount(1)
              .arraySize(1)
              .mipCount(1);
      PointerBuffer handle = stack.mallocPointer(1);
      check("CreateSwapchain", XR10.xrCreateSwapchain(session, info, handle));
      swapchains.put(handle.get(0), new XrSwapchain(handle.get(0), session));
      return handle.get(0);
    }
  }

  @Override
  public int[] textures(long swapchain) {
    String function = "EnumerateSwapchainImages";
    XrSwapchain chain = swapchains.get(swapchain);
    try (MemoryStack stack = MemoryStack.stackPush()) {
      IntBuffer count = stack.ints(0);
      check(function, XR10.xrEnumerateSwapchainImages(chain, count, null));
      XrSwapchainImageOpenGLKHR.Buffer images =
          XrSwapchainImageOpenGLKHR.calloc(count.get(0), stack);
      images.forEach(XrSwapchainImageOpenGLKHR::type$Default);
      check(
          function,
          XR10.xrEnumerateSwapchainImages(
              chain,
              count,
              XrSwapchainImageBaseHeader.create(images.address(), images.capacity())));
      return images.stream().mapToInt(XrSwapchainImageOpenGLKHR::image).toArray();
    }
  }

  @Override
  public int acquire(long swapchain) {
    XrSwapchain chain = swapchains.get(swapchain);
    try (MemoryStack stack = MemoryStack.stackPush()) {
      IntBuffer index = stack.mallocInt(1);
      check(
          "AcquireSwapchainImage",
          XR10.xrAcquireSwapchainImage(
              chain, XrSwapchainImageAcquireInfo.calloc(stack).type$Default(), index));
      check(
          "WaitSwapchainImage",
          XR10.xrWaitSwapchainImage(
              chain, XrSwapchainImageWaitInfo.calloc(stack).type$Default().timeout(PATIENCE)));
      return index.get(0);
    }
  }

  @Override
  public void release(long swapchain) {
    try (MemoryStack stack = MemoryStack.stackPush()) {
      check(
          "ReleaseSwapchainImage",
          XR10.xrReleaseSwapchainImage(
              swapchains.get(swapchain), XrSwapchainImageReleaseInfo.calloc(stack).type$Default()));
    }
  }

  @Override
  public void begin() {
    try (MemoryStack stack = MemoryStack.stackPush()) {
      check(
          "BeginSession",
          XR10.xrBeginSession(
              session,
              XrSessionBeginInfo.calloc(stack)
                  .type$Default()
                  .primaryViewConfigurationType(STEREO)));
    }
  }

  @Override
  public void end() {
    check("EndSession", XR10.xrEndSession(session));
  }

  @Override
  public FrameTime waitFrame() {
    try (MemoryStack stack = MemoryStack.stackPush()) {
      XrFrameState state = XrFrameState.calloc(stack).type$Default();
      check(
          "WaitFrame",
          XR10.xrWaitFrame(session, XrFrameWaitInfo.calloc(stack).type$Default(), state));
      return new FrameTime(
          state.predictedDisplayTime(), state.predictedDisplayPeriod(), state.shouldRender());
    }
  }

  @Override
  public void beginFrame() {
    try (MemoryStack stack = MemoryStack.stackPush()) {
      check(
          "BeginFrame", XR10.xrBeginFrame(session, XrFrameBeginInfo.calloc(stack).type$Default()));
    }
  }

  @Override
  public void endFrame(long display, int blendMode, long space, List<EyePicture> pictures) {
    try (MemoryStack stack = MemoryStack.stackPush()) {
      XrFrameEndInfo info =
          XrFrameEndInfo.calloc(stack)
              .type$Default()
              .displayTime(display)
              .environmentBlendMode(blendMode);
      if (!pictures.isEmpty()) {
        XrCompositionLayerProjectionView.Buffer views =
            XrCompositionLayerProjectionView.calloc(pictures.size(), stack);
        for (int i = 0; i < pictures.size(); i++) {
          fill(views.get(i).type$Default(), pictures.get(i));
        }
        XrCompositionLayerProjection layer =
            XrCompositionLayerProjection.calloc(stack)
                .type$Default()
                .space(spaces.get(space))
                .views(views);
        info.layers(stack.pointers(layer.address())).layerCount(1);
      }
      check("EndFrame", XR10.xrEndFrame(session, info));
    }
  }

  private void fill(XrCompositionLayerProjectionView view, EyePicture picture) {
    XrEyeView sight = picture.sight();
    Vector3d at = sight.pose().position();
    Quaterniond turn = sight.pose().orientation();
    view.pose().position$().set((float) at.x, (float) at.y, (float) at.z);
    view.pose().orientation().set((float) turn.x, (float) turn.y, (float) turn.z, (float) turn.w);
    view.fov()
        .angleLeft((float) Math.atan(sight.left()))
        .angleRight((float) Math.atan(sight.right()))
        .angleDown((float) Math.atan(sight.bottom()))
        .angleUp((float) Math.atan(sight.top()));
    view.subImage().swapchain(swapchains.get(picture.swapchain()));
    view.subImage().imageRect().extent().set(picture.width(), picture.height());
  }

  @Override
  public VisibilityMask hidden(int eye) {
    try (MemoryStack stack = MemoryStack.stackPush()) {
      XrVisibilityMaskKHR mask = XrVisibilityMaskKHR.calloc(stack).type$Default();
      readMask(eye, mask);
      int corners = mask.vertexCountOutput();
      int indices = mask.indexCountOutput();
      if (corners == 0 || indices == 0) {
        return VisibilityMask.NONE;
      }
      XrVector2f.Buffer points = XrVector2f.calloc(corners);
      IntBuffer numbers = MemoryUtil.memCallocInt(indices);
      try {
        mask.vertices(points).vertexCapacityInput(corners);
        mask.indices(numbers).indexCapacityInput(indices);
        readMask(eye, mask);
        float[] flat = new float[2 * indices];
        for (int i = 0; i < indices; i++) {
          XrVector2f point = points.get(numbers.get(i));
          flat[2 * i] = point.x();
          flat[2 * i + 1] = point.y();
        }
        return new VisibilityMask(flat);
      } finally {
        points.free();
        MemoryUtil.memFree(numbers);
      }
    }
  }

  private void readMask(int eye, XrVisibilityMaskKHR mask) {
    int hidden = KHRVisibilityMask.XR_VISIBILITY_MASK_TYPE_HIDDEN_TRIANGLE_MESH_KHR;
    check(
        "GetVisibilityMaskKHR",
        KHRVisibilityMask.xrGetVisibilityMaskKHR(session, STEREO, eye, hidden, mask));
  }

  @Override
  public void close() {
    swapchains.values().forEach(XR10::xrDestroySwapchain);
    spaces.values().forEach(XR10::xrDestroySpace);
    XR10.xrDestroySession(session);
  }
}
