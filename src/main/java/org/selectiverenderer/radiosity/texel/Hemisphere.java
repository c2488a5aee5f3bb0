package org.selectiverenderer.radiosity.texel;

import java.util.Arrays;
import org.selectiverenderer.radiosity.sampling.Directions;
import org.selectiverenderer.radiosity.sampling.PointSet;
import org.selectiverenderer.radiosity.scene.LightScene;
import org.selectiverenderer.radiosity.solve.DirectLight;
import org.selectiverenderer.radiosity.trace.Ray;

/** Rays from one place to all that it sees. One per thread. */
final class Hemisphere {
  /** Different sets of directions: neighbours' errors must not agree. */
  private static final int SETS = 64;

  /** Parts of a set that are compared to know its error. */
  private static final int PARTS = 8;

  /** A place that meets so many backs, as a share of its rays, lies inside of something. */
  private static final double BURIED = 0.25;

  /**
   * Covered: so many of the rays end so near, in offsets of starts, that something lies right on
   * the place. Through a wider gap it can be seen, and it is dark.
   */
  private static final double COVERED = 0.95;

  private static final double TOUCHING = 4;

  /** Of the offset of starts: the rest is the place itself. */
  private static final double OVERLAID = 0.9;

  /** Rays that say whether a place lies in a hollow, and how wide hollows are, texels. */
  private static final int HOLLOW_RAYS = 32;

  private static final double HOLLOW = 12;

  private static final int FEW = 4;

  /** Places on each lamp to know whether it shines into a hollow. */
  private static final int LAMP_TRIES = 4;

  /** Directions flatter than this leave the triangle to its back. */
  private static final double FLAT = 0.005;

  /** Reflections between things that are near to each other that a ray follows. */
  private static final int MOST_BOUNCES = 4;

  /** Of flat rays no more than this counts for how light turns, as a cosine. */
  private static final double LEAST_COSINE = 0.1;

  private final LightScene scene;
  private final HitLight hits;
  private final Sets sets;
  private final Ray ray = new Ray();
  private final DirectLight lamps;
  private final double[] start = new double[3];
  private final double[] direction = new double[3];
  private final double[] radiance = new double[3];
  private final double[] toward = new double[3];
  private final double[] bounced = new double[3];
  private final double[] fromSurfaces = new double[3];
  private final double[] hitNormal = new double[3];
  private final double[] share = new double[3];
  private final double[] light = new double[3];
  private final double[] reflected = new double[3];
  private final double[] parts = new double[PARTS];
  private final NearWalls walls;

  /** Directions that all share. */
  record Sets(Directions directions, PointSet passes, int rays) {
    static Sets of(int rays, int seed) {
      return new Sets(
          new Directions(new PointSet(SETS * rays, seed, 22)),
          new PointSet(SETS * rays, seed, 23),
          rays);
    }
  }

  Hemisphere(LightScene scene, HitLight hits, Sets sets) {
    this.scene = scene;
    this.hits = hits;
    this.sets = sets;
    lamps = new DirectLight(scene, ray);
    walls = new NearWalls(scene);
  }

  /** Rays of one set. */
  int most() {
    return sets.rays();
  }

  long rays() {
    return ray.cast();
  }

  /**
   * Gathers at a place.
   *
   * @param turn which set of directions
   * @param fewer what share of the rays is cast: 1 for all, 2 for half and so on
   */
  void gather(TexelPlace place, int turn, int fewer, LightRecord out) {
    int rays = Math.max(PARTS, sets.rays() / fewer);
    int first = (PointSet.hash(turn) & SETS - 1) * sets.rays();
    Arrays.fill(out.light, 0);
    Arrays.fill(out.turn, 0);
    place.start(start);
    walls.begin(place.normal, place.size());
    double inverse = 0;
    int valid = 0;
    int backs = 0;
    int near = 0;
    int met = 0;
    for (int part = 0; part < PARTS; part++) {
      double sum = 0;
      int counted = 0;
      for (int i = part * rays / PARTS; i < (part + 1) * rays / PARTS; i++) {
        if (!cast(place, first + i)) {
          continue;
        }
        if (ray.triangle == Ray.NOTHING) {
          counted++;
          continue;
        }
        walls.met(ray);
        if (ray.behind && !twoSided()) {
          backs++;
          continue;
        }
        counted++;
        near += ray.length < TOUCHING * scene.offset() ? 1 : 0;
        met++;
        inverse += 1 / Math.max(1e-6, ray.length);
        System.arraycopy(direction, 0, toward, 0, 3);
        look(place.version, first + i);
        sum += radiance[0] + radiance[1] + radiance[2];
        add(place.normal, out);
      }
      parts[part] = counted == 0 ? 0 : sum / counted;
      valid += counted;
    }
    out.rays = rays;
    walls.write(out.walls);
    out.seen = backs <= BURIED * (backs + valid) && near < COVERED * valid;
    finish(valid, out);
    out.distance = inverse > 0 ? met / inverse : Double.POSITIVE_INFINITY;
  }

  /** How many texels away one ray ends, if that is within some texels; else infinite. */
  double near(TexelPlace place, int i, int turn, double most) {
    place.start(start);
    sets.directions()
        .about(place.normal, (PointSet.hash(turn) & SETS - 1) * sets.rays() + i, direction);
    if (dot(direction, place.facing) < FLAT) {
      return Double.POSITIVE_INFINITY;
    }
    ray.from(start, direction);
    ray.length = most * place.size();
    ray.pass = 0.5;
    scene.visibility().nearest(ray, place.version);
    return ray.triangle != Ray.NOTHING ? ray.length / place.size() : Double.POSITIVE_INFINITY;
  }

  /** Whether a place lies inside of something or is covered closely, as few rays tell. */
  boolean unseen(TexelPlace place, int rays, int turn) {
    int first = (PointSet.hash(turn) & SETS - 1) * sets.rays();
    place.start(start);
    int backs = 0;
    int near = 0;
    int valid = 0;
    for (int i = 0; i < rays; i++) {
      if (cast(place, first + i)) {
        valid++;
        boolean met = ray.triangle != Ray.NOTHING;
        backs += met && ray.behind && !twoSided() ? 1 : 0;
        near += met && ray.length < TOUCHING * scene.offset() ? 1 : 0;
      }
    }
    return 2 * backs >= valid && backs > 0 || near == valid && near > 0;
  }

  /**
   * Whether a place lies right under a sheet, or in a closed hollow without a lamp. Nobody sees it,
   * as light would come in where eyes look in; and none does if nothing that is sent out from there
   * gets far, however often it is thrown back.
   */
  boolean hollow(TexelPlace place, int turn) {
    int first = (PointSet.hash(turn) & SETS - 1) * sets.rays();
    double most = HOLLOW * place.size();
    place.start(start);
    if (overlaid(place)) {
      return true;
    }
    int rays = Math.min(HOLLOW_RAYS, sets.rays());
    int sent = 0;
    // Most places are told by a few rays that are not followed.
    for (int follow = 0; follow <= MOST_BOUNCES; follow += MOST_BOUNCES) {
      for (int i = 0; i < (follow == 0 ? FEW : rays); i++) {
        if (cast(place, first + i)) {
          if (getsOut(place.version, first + i, follow, most)) {
            return false;
          }
          sent++;
        }
      }
    }
    return sent > 0 && !lit(place);
  }

  /** Whether a sheet lies on the place, so near that rays start beyond it. */
  private boolean overlaid(TexelPlace place) {
    for (int axis = 0; axis < 3; axis++) {
      direction[axis] = -place.facing[axis];
    }
    ray.from(start, direction);
    ray.length = OVERLAID * scene.offset();
    ray.pass = 0.5;
    scene.visibility().nearest(ray, place.version);
    return ray.triangle != Ray.NOTHING;
  }

  /** Whether the ray, or what is thrown back where it ends, comes to a lamp or goes far. */
  private boolean getsOut(int version, int i, int follow, double most) {
    for (int bounce = 0; ; bounce++) {
      if (far(most) || glows(hits.patch(ray))) {
        return true;
      }
      if (bounce == follow || !turnBack(version, PointSet.hash(i + 0x632be5ab * (bounce + 1)))) {
        return far(most);
      }
    }
  }

  private boolean glows(int patch) {
    return hits.glow(patch, 0) + hits.glow(patch, 1) + hits.glow(patch, 2) > 0;
  }

  private boolean far(double most) {
    return ray.triangle == Ray.NOTHING || ray.length > most;
  }

  /** Whether some place of a lamp is seen from the middle of a texel. */
  private boolean lit(TexelPlace place) {
    Arrays.fill(light, 0);
    for (int i = 0; i < LAMP_TRIES; i++) {
      double s = (i + 0.5) / LAMP_TRIES;
      double t = (i * 0.618034 + 0.5) % 1;
      if (lamps.add(start, place.normal, place.version, s, t, DirectLight.ALL, light) != 0) {
        return true;
      }
    }
    return light[0] + light[1] + light[2] > 0;
  }

  private boolean cast(TexelPlace place, int i) {
    sets.directions().about(place.normal, i, direction);
    if (dot(direction, place.facing) < FLAT) {
      return false;
    }
    ray.from(start, direction);
    ray.length = Double.POSITIVE_INFINITY;
    ray.pass = sets.passes().x(i);
    scene.visibility().nearest(ray, place.version);
    return true;
  }

  private boolean twoSided() {
    return scene.triangles().twoSided()[ray.triangle];
  }

  /**
   * Finds the radiance of what the ray has met. Where that is near, as in a corner or under
   * furniture, the light from surfaces there is not the patch's: one more ray fetches it.
   */
  private void look(int version, int i) {
    Arrays.fill(radiance, 0);
    Arrays.fill(share, 1);
    for (int bounce = 0; ; bounce++) {
      int patch = hits.patch(ray);
      hits.reflectance(ray, reflected);
      hits.direct(ray, patch, light);
      boolean goesOn = bounce < MOST_BOUNCES && hits.near(ray, patch);
      if (!goesOn) {
        hits.indirect(patch, fromSurfaces);
      }
      for (int c = 0; c < 3; c++) {
        double arriving = light[c] + (goesOn ? 0 : fromSurfaces[c]);
        radiance[c] += share[c] * (hits.glow(patch, c) + reflected[c] * arriving / Math.PI);
        share[c] *= reflected[c];
      }
      if (!goesOn || !bounce(version, PointSet.hash(i + 0x632be5ab * (bounce + 1)))) {
        return;
      }
    }
  }

  /**
   * Sends the ray on from before where it has ended: off the surface there may be another one, in a
   * gap that is less than an offset wide. False if it meets nothing that has light.
   */
  private boolean turnBack(int version, int turn) {
    double length = ray.length - Math.min(scene.offset(), ray.length) / 2;
    bounced[0] = ray.ox + length * ray.dx;
    bounced[1] = ray.oy + length * ray.dy;
    bounced[2] = ray.oz + length * ray.dz;
    faceHit();
    return sendOn(version, turn);
  }

  private void faceHit() {
    scene.triangles().normal(ray.triangle, hitNormal);
    for (int axis = 0; axis < 3; axis++) {
      hitNormal[axis] *= ray.behind ? -1 : 1;
    }
  }

  /** Sends the ray on from where it has ended; false if it meets nothing that has light. */
  private boolean bounce(int version, int turn) {
    faceHit();
    bounced[0] = ray.ox + ray.length * ray.dx + scene.offset() * hitNormal[0];
    bounced[1] = ray.oy + ray.length * ray.dy + scene.offset() * hitNormal[1];
    bounced[2] = ray.oz + ray.length * ray.dz + scene.offset() * hitNormal[2];
    return sendOn(version, turn);
  }

  private boolean sendOn(int version, int turn) {
    int i = (turn >>> 1) % sets.directions().size();
    sets.directions().about(hitNormal, i, direction);
    ray.from(bounced, direction);
    ray.length = Double.POSITIVE_INFINITY;
    ray.pass = sets.passes().y(i);
    scene.visibility().nearest(ray, version);
    return ray.triangle != Ray.NOTHING && (!ray.behind || twoSided());
  }

  private static double dot(double[] a, double[] b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }

  private void add(double[] n, LightRecord out) {
    double cosine = dot(toward, n);
    double scale = 1 / Math.max(LEAST_COSINE, cosine);
    for (int c = 0; c < 3; c++) {
      out.light[c] += radiance[c];
      for (int axis = 0; axis < 3; axis++) {
        out.turn[3 * c + axis] += radiance[c] * scale * (toward[axis] - cosine * n[axis]);
      }
    }
  }

  private void finish(int valid, LightRecord out) {
    double scale = valid == 0 ? 0 : Math.PI / valid;
    for (int c = 0; c < 3; c++) {
      out.light[c] *= scale;
    }
    for (int i = 0; i < 9; i++) {
      out.turn[i] *= scale;
    }
    double mean = Arrays.stream(parts).sum() / PARTS;
    double squares = 0;
    for (double part : parts) {
      squares += (part - mean) * (part - mean);
    }
    out.error = Math.PI * Math.sqrt(squares / (PARTS * (PARTS - 1)));
  }
}
