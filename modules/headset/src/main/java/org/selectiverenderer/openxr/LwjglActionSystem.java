package org.selectiverenderer.openxr;

import static org.selectiverenderer.openxr.LwjglLoader.check;

import java.nio.ByteBuffer;
import java.nio.IntBuffer;
import java.nio.LongBuffer;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import org.joml.Vector2d;
import org.jspecify.annotations.Nullable;
import org.lwjgl.PointerBuffer;
import org.lwjgl.openxr.XR10;
import org.lwjgl.openxr.XrAction;
import org.lwjgl.openxr.XrActionCreateInfo;
import org.lwjgl.openxr.XrActionSet;
import org.lwjgl.openxr.XrActionSetCreateInfo;
import org.lwjgl.openxr.XrActionSpaceCreateInfo;
import org.lwjgl.openxr.XrActionStateBoolean;
import org.lwjgl.openxr.XrActionStateGetInfo;
import org.lwjgl.openxr.XrActionStatePose;
import org.lwjgl.openxr.XrActionStateVector2f;
import org.lwjgl.openxr.XrActionSuggestedBinding;
import org.lwjgl.openxr.XrActionsSyncInfo;
import org.lwjgl.openxr.XrActiveActionSet;
import org.lwjgl.openxr.XrInteractionProfileState;
import org.lwjgl.openxr.XrInteractionProfileSuggestedBinding;
import org.lwjgl.openxr.XrSessionActionSetsAttachInfo;
import org.lwjgl.openxr.XrSpace;
import org.lwjgl.system.MemoryStack;
import org.lwjgl.system.MemoryUtil;

/**
 * The action system of LWJGL's OpenXR, with one action set for the whole program. Actions are
 * destroyed with their instance.
 */
final class LwjglActionSystem implements XrActionSystem {
  private final org.lwjgl.openxr.XrInstance instance;
  private final XrActionSet set;
  private final Map<Long, XrAction> actions = new HashMap<>();
  private @Nullable LwjglSession session;

  LwjglActionSystem(org.lwjgl.openxr.XrInstance instance) {
    this.instance = instance;
    try (MemoryStack stack = MemoryStack.stackPush()) {
      XrActionSetCreateInfo info =
          XrActionSetCreateInfo.calloc(stack)
              .type$Default()
              .actionSetName(stack.UTF8("scene"))
              .localizedActionSetName(stack.UTF8("In the scene"));
      PointerBuffer handle = stack.mallocPointer(1);
      check("CreateActionSet", XR10.xrCreateActionSet(instance, info, handle));
      set = new XrActionSet(handle.get(0), instance);
    }
  }

  @Override
  public long action(String name, String shown, Kind kind) {
    try (MemoryStack stack = MemoryStack.stackPush()) {
      XrActionCreateInfo info =
          XrActionCreateInfo.calloc(stack)
              .type$Default()
              .actionType(kind.number())
              .actionName(stack.UTF8(name))
              .localizedActionName(stack.UTF8(shown));
      PointerBuffer handle = stack.mallocPointer(1);
      check("CreateAction", XR10.xrCreateAction(set, info, handle));
      actions.put(handle.get(0), new XrAction(handle.get(0), set));
      return handle.get(0);
    }
  }

  private long path(String text) {
    try (MemoryStack stack = MemoryStack.stackPush()) {
      LongBuffer path = stack.mallocLong(1);
      check("StringToPath", XR10.xrStringToPath(instance, text, path));
      return path.get(0);
    }
  }

  @Override
  public void suggest(String profile, List<Map.Entry<Long, String>> bindings) {
    try (MemoryStack stack = MemoryStack.stackPush()) {
      XrActionSuggestedBinding.Buffer all = XrActionSuggestedBinding.calloc(bindings.size(), stack);
      for (int i = 0; i < bindings.size(); i++) {
        all.get(i)
            .action(actions.get(bindings.get(i).getKey()))
            .binding(path(bindings.get(i).getValue()));
      }
      XrInteractionProfileSuggestedBinding info =
          XrInteractionProfileSuggestedBinding.calloc(stack)
              .type$Default()
              .interactionProfile(path(profile))
              .suggestedBindings(all);
      check(
          "SuggestInteractionProfileBindings",
          XR10.xrSuggestInteractionProfileBindings(instance, info));
    }
  }

  @Override
  public void attach(XrSession to) {
    LwjglSession real = (LwjglSession) to;
    session = real;
    try (MemoryStack stack = MemoryStack.stackPush()) {
      XrSessionActionSetsAttachInfo info =
          XrSessionActionSetsAttachInfo.calloc(stack)
              .type$Default()
              .actionSets(stack.pointers(set.address()));
      check("AttachSessionActionSets", XR10.xrAttachSessionActionSets(real.handle(), info));
    }
  }

  private LwjglSession session() {
    LwjglSession known = session;
    if (known == null) {
      throw new IllegalStateException("no session has the actions yet");
    }
    return known;
  }

  @Override
  public boolean sync() {
    try (MemoryStack stack = MemoryStack.stackPush()) {
      XrActiveActionSet.Buffer active = XrActiveActionSet.calloc(1, stack).actionSet(set);
      XrActionsSyncInfo info =
          XrActionsSyncInfo.calloc(stack)
              .type$Default()
              .countActiveActionSets(1)
              .activeActionSets(active);
      int result = check("SyncActions", XR10.xrSyncActions(session().handle(), info));
      return result != XR10.XR_SESSION_NOT_FOCUSED;
    }
  }

  /** A function that gets the state of an action from the runtime. */
  private interface Asked<S> {
    int get(org.lwjgl.openxr.XrSession session, XrActionStateGetInfo info, S state);
  }

  /**
   * Gets the state of an action.
   *
   * @param name name of the function, for messages
   * @param empty allocates the struct that the runtime fills in
   * @param found reads the result from the struct before its memory is freed
   */
  private <S, T> T state(
      String name,
      long action,
      Function<MemoryStack, S> empty,
      Asked<S> asked,
      Function<S, T> found) {
    try (MemoryStack stack = MemoryStack.stackPush()) {
      S state = empty.apply(stack);
      XrActionStateGetInfo info =
          XrActionStateGetInfo.calloc(stack).type$Default().action(actions.get(action));
      check(name, asked.get(session().handle(), info, state));
      return found.apply(state);
    }
  }

  @Override
  public boolean button(long action) {
    return state(
        "GetActionStateBoolean",
        action,
        stack -> XrActionStateBoolean.calloc(stack).type$Default(),
        XR10::xrGetActionStateBoolean,
        state -> state.isActive() && state.currentState());
  }

  @Override
  public Vector2d stick(long action) {
    return state(
        "GetActionStateVector2f",
        action,
        stack -> XrActionStateVector2f.calloc(stack).type$Default(),
        XR10::xrGetActionStateVector2f,
        state ->
            state.isActive()
                ? new Vector2d(state.currentState().x(), state.currentState().y())
                : new Vector2d());
  }

  @Override
  public boolean active(long action) {
    return state(
        "GetActionStatePose",
        action,
        stack -> XrActionStatePose.calloc(stack).type$Default(),
        XR10::xrGetActionStatePose,
        XrActionStatePose::isActive);
  }

  @Override
  public long space(long action) {
    try (MemoryStack stack = MemoryStack.stackPush()) {
      XrActionSpaceCreateInfo info =
          XrActionSpaceCreateInfo.calloc(stack)
              .type$Default()
              .action(actions.get(action))
              .poseInActionSpace(pose -> pose.orientation().w(1));
      PointerBuffer handle = stack.mallocPointer(1);
      check("CreateActionSpace", XR10.xrCreateActionSpace(session().handle(), info, handle));
      return session().known(new XrSpace(handle.get(0), session().handle()));
    }
  }

  @Override
  public Optional<String> profile(String hand) {
    try (MemoryStack stack = MemoryStack.stackPush()) {
      XrInteractionProfileState state = XrInteractionProfileState.calloc(stack).type$Default();
      check(
          "GetCurrentInteractionProfile",
          XR10.xrGetCurrentInteractionProfile(session().handle(), path(hand), state));
      if (state.interactionProfile() == XR10.XR_NULL_PATH) {
        return Optional.empty();
      }
      IntBuffer count = stack.ints(0);
      check("PathToString", XR10.xrPathToString(instance, state.interactionProfile(), count, null));
      ByteBuffer text = stack.malloc(count.get(0));
      check("PathToString", XR10.xrPathToString(instance, state.interactionProfile(), count, text));
      return Optional.of(MemoryUtil.memUTF8(text, count.get(0) - 1));
    }
  }
}
