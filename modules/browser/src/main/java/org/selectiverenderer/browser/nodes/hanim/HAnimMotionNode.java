package org.selectiverenderer.browser.nodes.hanim;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.joml.Quaterniond;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.nodes.group.TransformNode;
import org.selectiverenderer.browser.nodes.sensor.FrameContext;
import org.selectiverenderer.browser.nodes.sensor.FrameDrivenNode;
import org.selectiverenderer.browser.scene.EventCascade;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.scene.Rotations;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeType;

/**
 * HAnimMotion (X3D 4.0, 26.3.4): plays recorded motion of a humanoid's joints. Its channels are
 * those of BVH files: rotations in degrees about X, Y, Z in the order of the channels, and
 * translations. It plays while enabled, from {@code startFrame} to {@code endFrame} (0 for the
 * last), each frame for {@code frameDuration}.
 */
public final class HAnimMotionNode extends Node implements FrameDrivenNode {
  /** One value of a frame: the joint and the axis of its translation or rotation. */
  private record Channel(String joint, int axis, boolean turns) {}

  private final int enabled;
  private final int frameIndex;
  private Map<String, TransformNode> joints = Map.of();
  private List<Channel> channels = List.of();
  private @Nullable String channelsOf;
  private @Nullable String jointsOf;
  private boolean allowed = true;
  private double last = Double.NaN;
  private double begun;

  public HAnimMotionNode(NodeType type, @Nullable String name, SourceLocation location) {
    super(type, name, location);
    enabled = type.indexOf("enabled");
    frameIndex = type.indexOf("frameIndex");
  }

  /**
   * Sets the joints to be moved, those of the humanoid.
   *
   * @param may whether the humanoid's {@code motionsEnabled} allows the motion
   */
  void joints(List<TransformNode> all, boolean may) {
    Map<String, TransformNode> byName = new HashMap<>();
    all.forEach(joint -> byName.putIfAbsent(joint.string("name"), joint));
    joints = byName;
    allowed = may;
  }

  @Override
  public void frame(FrameContext frame, EventCascade cascade) {
    if (!(Boolean) value(enabled) || !allowed) {
      last = Double.NaN;
      return;
    }
    int count = frames();
    double duration = (Double) value("frameDuration");
    if (count == 0 || !(duration > 0)) {
      return;
    }
    double now = frame.time();
    if (Double.isNaN(last)) {
      last = now;
      begun = now;
      emit(type().indexOf("cycleTime"), now, cascade);
      if (integer("frameCount") != count) {
        emit(type().indexOf("frameCount"), count, cascade);
      }
      show(Math.max(integer("startFrame"), Math.min(integer("frameIndex"), count - 1)), cascade);
      return;
    }
    emit(type().indexOf("elapsedTime"), now - begun, cascade);
    double steps = Math.floor((now - last) / duration + 1e-6);
    if (steps > 0) {
      last += steps * duration;
      advance(steps * integer("frameIncrement"), count, cascade);
    }
  }

  private void advance(double by, int count, EventCascade cascade) {
    int start = Math.max(0, Math.min(integer("startFrame"), count - 1));
    int end = integer("endFrame");
    end = end <= start || end >= count ? count - 1 : end;
    double next = integer("frameIndex") + by;
    if (next >= start && next <= end) {
      show((int) next, cascade);
    } else if (bool("loop")) {
      int length = end - start + 1;
      emit(type().indexOf("cycleTime"), cascade.time(), cascade);
      double into = (next - start) % length;
      show(start + (int) (into < 0 ? into + length : into), cascade);
    } else {
      show(next > end ? end : start, cascade);
      emit(enabled, false, cascade);
    }
  }

  @Override
  protected void receive(FieldDefinition field, @Nullable Object value, EventCascade cascade) {
    int step = field.name().equals("next") ? 1 : field.name().equals("previous") ? -1 : 0;
    if (step == 0) {
      super.receive(field, value, cascade);
      if (field.index() == frameIndex && frames() > 0) {
        pose(integer("frameIndex"), cascade);
      }
    } else if ((Boolean) value && frames() > 0) {
      show(Math.floorMod(integer("frameIndex") + step, frames()), cascade);
    }
  }

  private int frames() {
    read();
    return channels.isEmpty() ? 0 : floats("values").length / channels.size();
  }

  private void show(int number, EventCascade cascade) {
    emit(frameIndex, number, cascade);
    pose(number, cascade);
  }

  /** Sends a frame's translations and rotations to the joints. */
  private void pose(int number, EventCascade cascade) {
    if (number < 0 || number >= frames()) {
      return;
    }
    float[] values = floats("values");
    boolean[] on = (boolean[]) value("channelsEnabled");
    Map<String, Quaterniond> turns = new HashMap<>();
    Map<String, float[]> moves = new HashMap<>();
    for (int i = 0; i < channels.size(); i++) {
      Channel channel = channels.get(i);
      TransformNode joint = joints.get(channel.joint);
      if (joint == null || i < on.length && !on[i]) {
        continue;
      }
      float value = values[number * channels.size() + i];
      if (channel.turns) {
        Quaterniond turn = turns.computeIfAbsent(channel.joint, name -> new Quaterniond());
        double angle = Math.toRadians(value);
        switch (channel.axis) {
          case 0 -> turn.rotateX(angle);
          case 1 -> turn.rotateY(angle);
          default -> turn.rotateZ(angle);
        }
      } else {
        moves
                .computeIfAbsent(channel.joint, name -> joint.floats("translation").clone())[
                channel.axis] =
            value;
      }
    }
    moves.forEach((name, move) -> send(name, "translation", move, cascade));
    turns.forEach(
        (name, turn) -> {
          float[] rotation = new float[4];
          Rotations.write(turn, rotation);
          send(name, "rotation", rotation, cascade);
        });
  }

  private void send(String name, String field, float[] value, EventCascade cascade) {
    TransformNode joint = joints.get(name);
    if (joint != null) {
      cascade.send(joint, joint.type().indexOf(field), value);
    }
  }

  /** Parses the names of joints and channels if they have changed. */
  private void read() {
    String named = string("joints");
    String given = string("channels");
    if (named.equals(jointsOf) && given.equals(channelsOf)) {
      return;
    }
    jointsOf = named;
    channelsOf = given;
    String[] names = named.strip().split("[\\s,]+");
    List<Channel> all = new ArrayList<>();
    int joint = -1;
    for (String word : given.strip().split("[\\s,]+")) {
      String lower = word.toLowerCase(Locale.ROOT);
      int axis = lower.isEmpty() ? -1 : "xyz".indexOf(lower.charAt(0));
      boolean turns = lower.endsWith("rotation");
      if (axis >= 0 && (turns || lower.endsWith("position"))) {
        String name = joint >= 0 && joint < names.length ? names[joint] : "";
        all.add(new Channel(name, axis, turns));
      } else {
        joint++; // A number: the count of the next joint's channels.
      }
    }
    channels = List.copyOf(all);
  }
}
