package org.selectiverenderer.browser.nodes.particle;

import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.nodes.sensor.FrameContext;
import org.selectiverenderer.browser.nodes.sensor.FrameDrivenNode;
import org.selectiverenderer.browser.scene.EventCascade;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.scene.ProceduralShape;
import org.selectiverenderer.browser.scene.Rotations;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeType;

/**
 * ParticleSystem (X3D 4.0, 40.4.9). New particles are created at a constant rate such that {@code
 * maxParticles} live at a time; an explosion creates all of them at once, and again when their
 * lifetime is over. {@code isActive} is TRUE while the system is enabled and creates particles or
 * has some.
 */
public final class ParticleSystemNode extends Node implements FrameDrivenNode, ProceduralShape {
  /** Largest number of particles. */
  public static final int MOST = 20_000;

  /** Duration of a simulation step in seconds. */
  static final double STEP = 1.0 / 60;

  /** Largest number of simulation steps in a frame; earlier particles would have expired. */
  private static final int MOST_STEPS = 600;

  private final int enabled;
  private final int isActive;
  private final int maxParticles;
  private final int appearance;
  private SurfaceMeshCache meshes = new SurfaceMeshCache(node -> Optional.empty());
  private ParticlePool particles = new ParticlePool(0);
  private ParticleRandom chance = new ParticleRandom(0);
  private @Nullable Mesh mesh;
  private double begun = Double.NaN;
  private long steps;
  private double owed;
  private double exploded = Double.NEGATIVE_INFINITY;

  public ParticleSystemNode(NodeType type, @Nullable String name, SourceLocation location) {
    super(type, name, location);
    enabled = type.indexOf("enabled");
    isActive = type.indexOf("isActive");
    maxParticles = type.indexOf("maxParticles");
    appearance = type.indexOf("appearance");
  }

  @Override
  public Optional<Mesh> form() {
    return Optional.ofNullable(mesh);
  }

  @Override
  public void meshes(Function<Node, Optional<Mesh>> source) {
    meshes = new SurfaceMeshCache(source);
  }

  private boolean active() {
    return (Boolean) value(isActive);
  }

  @Override
  public void frame(FrameContext frame, EventCascade cascade) {
    Node emitter = node("emitter");
    if (!(Boolean) value(enabled) || emitter == null) {
      stop(cascade);
      return;
    }
    boolean creates = bool("createParticles") && emitter.bool("on");
    if (!creates && particles.count() == 0) {
      stop(cascade);
      return;
    }
    if (Double.isNaN(begun)) {
      start(frame.time());
    }
    if (!active()) {
      emit(isActive, true, cascade);
    }
    double passed = frame.time() - begun;
    advance(emitter, creates, (long) Math.floor(passed / STEP + 1e-6));
    draw(frame, Math.max(0, passed - steps * STEP));
  }

  private void start(double now) {
    begun = now;
    steps = 0;
    owed = 0;
    exploded = Double.NEGATIVE_INFINITY;
    particles = new ParticlePool(Math.max(0, Math.min((Integer) value(maxParticles), MOST)));
    String seed = name();
    chance = new ParticleRandom(seed == null ? location().toString().hashCode() : seed.hashCode());
  }

  private void stop(EventCascade cascade) {
    begun = Double.NaN;
    particles.clear();
    if (mesh != null) {
      mesh = null;
      tellObservers(appearance);
    }
    if (active()) {
      emit(isActive, false, cascade);
    }
  }

  private void advance(Node emitter, boolean creates, long until) {
    if (until <= steps) {
      return;
    }
    // The present fields of emitters and physics models hold for all steps of this frame.
    ParticleEmitter emission =
        creates ? ParticleEmitterFactory.of(emitter, meshes).orElse(null) : null;
    ParticlePhysics physics = new ParticlePhysics(nodes("physics"), emitter, meshes);
    steps = Math.max(steps, until - MOST_STEPS);
    for (; steps < until; steps++) {
      particles.step(STEP, physics, chance);
      if (emission != null) {
        create(emitter, emission, physics);
      }
    }
  }

  private void create(Node emitter, ParticleEmitter from, ParticlePhysics acting) {
    double lifetime = number("particleLifetime");
    if (!(lifetime > 0) || particles.positions.length == 0) {
      return;
    }
    boolean explosion = emitter.type().name().equals("ExplosionEmitter");
    int wanted;
    if (explosion) {
      double now = steps * STEP;
      boolean again = now - exploded >= lifetime;
      exploded = again ? now : exploded;
      wanted = again ? particles.positions.length : 0;
    } else {
      owed += particles.positions.length * STEP / lifetime;
      wanted = (int) owed;
      owed -= wanted;
    }
    for (int i = 0; i < wanted && !particles.full(); i++) {
      Vector3d position = new Vector3d();
      Vector3d velocity = new Vector3d();
      from.emit(chance, position, velocity);
      velocity.mul(chance.around(emitter.number("speed"), emitter.number("variation")));
      double lives = chance.around(lifetime, number("lifetimeVariation"));
      // Particles are spread over the step, so that a stream has no gaps.
      double age = explosion ? 0 : chance.part() * STEP;
      acting.move(position, velocity, age);
      if (lives > age && position.isFinite() && velocity.isFinite()) {
        particles.add(position, velocity, age, lives);
      }
    }
  }

  private void draw(FrameContext frame, double ahead) {
    Vector3d right = new Vector3d(1, 0, 0);
    Vector3d up = new Vector3d(0, 1, 0);
    List<? extends Matrix4dc> places = frame.places(this);
    if (string("geometryType").equals("SPRITE") && !places.isEmpty()) {
      // Sprites share the viewer's up and face the viewer of the first instance.
      Matrix4d local = places.get(0).invert(new Matrix4d());
      local.transformDirection(frame.orientation().transform(right)).normalize();
      local.transformDirection(Rotations.up(frame.orientation(), up)).normalize();
      if (!right.isFinite() || !up.isFinite()) {
        right.set(1, 0, 0);
        up.set(0, 1, 0);
      }
    }
    Node geometry = node("geometry");
    Mesh each =
        string("geometryType").equals("GEOMETRY") && geometry != null
            ? meshes.mesh(geometry).orElse(null)
            : null;
    mesh = new ParticleMeshBuilder(this, particles, ahead).make(right, up, each);
    tellObservers(appearance);
  }

  @Override
  protected void receive(FieldDefinition field, @Nullable Object value, EventCascade cascade) {
    super.receive(field, value, cascade);
    if (field.index() == maxParticles) {
      begun = Double.NaN; // Restarts with the new number.
      particles.clear();
    }
  }
}
