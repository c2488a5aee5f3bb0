// The selective rendering controller: it sets the choice of each object's Switch, and the level of each field that
// is a quality of an object, such as the url of a texture, by the memory schemas of the areas that the viewer is in
// (A. Zotos, A real time selective rendering algorithm based on spatial cognition, Figs 48 and 49), for areas that may
// be nested and overlap:
//
//   - Entering an area activates its schemas. A Switch shows the choice of the last of them that it has a choice
//     for; of several entered areas the one entered last takes precedence.
//   - Leaving an area ends its precedence. A Switch that has a choice for a schema of another entered area shows
//     that one; any other shows its choice for the exit schemas of the area left, and is unchanged without one.
//
// The fields of this Script hold what the metadata of the scene say, one entry for each area or object, in the
// order of the scene. Lists of lists are flat: one field has the length of each, another the values of all.
//
//   condition       selective; or, set once and for all: high (all objects with all polygons), high-low
//                   (consistent ones with few), random (a random half of them with few)
//   seed            the random seed of the condition random
//   areaNames       DEF names of the ProximitySensors;  enterLengths, enterSchemas and exitLengths, exitSchemas:
//                   the schemas that entering and leaving each of them activates
//   objectNames     DEF names of the Switches;  fieldNames: the fields. Below, both count as objects, the fields after
//                   the Switches, and a level of a field as a choice
//   choiceLengths   with choiceSchemas and choices: for each object the schemas that it has a choice for, and these
//   shown           what each object shows now;  most, least, highLow: its best choice, its worst one, and that of the
//                   condition high-low
//   lotLengths      with lotMembers and lotSeeds: the objects of which the condition random draws a half, each quality
//                   by itself
//   level0_1_url    the value of the first field, which is called url, at its second level, and so on;  begin0_url: the
//                   value in the file, where no level has it
//
// Only functions and arrays of ECMAScript 3 are used, so that every browser's engine runs it. Strings are in
// single quotes, since Xj3D takes double ones for the end of the text.

var enterOf = [];     // for each area, the schemas that entering activates
var exitOf = [];      // for each area, those that leaving activates
var choiceOf = [];    // for each object, its choice by schema
var objectsOf = {};   // for each schema, the objects that have a choice for it
var now = [];         // for each object, the choice that it shows
var entered = [];     // the areas that the viewer is in; the last is the one entered last
var arrived = [];     // entries and exits of this time stamp

function initialize() {
  enterOf = split(enterLengths, enterSchemas);
  exitOf = split(exitLengths, exitSchemas);
  var schemas = split(choiceLengths, choiceSchemas);
  var values = split(choiceLengths, choices);
  for (var object = 0; object < schemas.length; object++) {
    var byName = {};
    for (var i = 0; i < schemas[object].length; i++) {
      var key = keyOf(schemas[object][i]);
      byName[key] = values[object][i];
      if (!objectsOf[key]) {
        objectsOf[key] = [];
      }
      objectsOf[key].push(object);
    }
    choiceOf.push(byName);
    now.push(shown[object]);
  }
  begin();
}

// Another condition: all objects are set anew.
function setCondition(value) {
  condition = value;
  begin();
}

// Another random seed.
function setSeed(value) {
  seed = value;
  begin();
}

// Entries and exits of one time stamp count in the order of the areas in the scene, as in all browsers.
function eventsProcessed() {
  if (arrived.length == 0) {
    return;
  }
  var steps = arrived.sort(function (a, b) { return a.area - b.area; });
  arrived = [];
  for (var i = 0; i < steps.length; i++) {
    move(steps[i].area, steps[i].enters);
  }
}

function move(area, enters) {
  var inside = indexOf(entered, area) >= 0;
  if (enters == inside) {
    return;
  }
  if (enters) {
    entered.push(area);
    if (selective()) {
      follow(having(enterOf[area], {}), []);
    }
  } else {
    entered.splice(indexOf(entered, area), 1);
    if (selective()) {
      follow(having(exitOf[area], overruled()), exitOf[area]);
    }
  }
}

function selective() {
  return condition == 'selective';
}

// Sets all objects as the condition says; under 'selective' they follow the areas entered so far.
function begin() {
  if (selective()) {
    for (var object = 0; object < now.length; object++) {
      show(object, shown[object]);
    }
    follow(overruled(), []);
  } else if (condition == 'high') {
    showAll(most);
  } else if (condition == 'high-low') {
    showAll(highLow);
  } else if (condition == 'random') {
    showAll(randomHalf());
  }
}

function showAll(wanted) {
  for (var object = 0; object < now.length; object++) {
    show(object, wanted[object]);
  }
}

// Adds the objects that have a choice for one of the schemas, and show another one.
function having(schemas, found) {
  for (var i = 0; i < schemas.length; i++) {
    var key = keyOf(schemas[i]);
    var objects = objectsOf[key] || [];
    for (var j = 0; j < objects.length; j++) {
      if (choiceOf[objects[j]][key] != now[objects[j]]) {
        found[objects[j]] = true;
      }
    }
  }
  return found;
}

// The objects that have a choice for a schema of an entered area, and show another one.
function overruled() {
  var found = {};
  for (var i = 0; i < entered.length; i++) {
    having(enterOf[entered[i]], found);
  }
  return found;
}

// Sets each object by the entered areas, or by the exit schemas if these say nothing of it.
function follow(objects, exit) {
  for (var object = 0; object < now.length; object++) {
    if (objects[object]) {
      var schema = lastNamed(choiceOf[object], exit);
      if (schema != null) {
        show(object, choiceOf[object][schema]);
      }
    }
  }
}

function lastNamed(byName, exit) {
  for (var i = entered.length - 1; i >= -1; i--) {
    var schemas = i >= 0 ? enterOf[entered[i]] : exit;
    for (var j = schemas.length - 1; j >= 0; j--) {
      var key = keyOf(schemas[j]);
      if (byName[key] != undefined) {
        return key;
      }
    }
  }
  return null;
}

function show(object, choice) {
  if (now[object] != choice) {
    now[object] = choice;
    send(object, choice);
  }
}

// The level of a field that has a value now; -1 for none.
function levelOf(value, levels) {
  for (var i = 0; i < levels.length; i++) {
    if (String(levels[i]) == String(value)) {
      return i;
    }
  }
  return -1;
}

// The lots of the condition 'random': Java's Random and Collections.shuffle, so that the same seed gives the same
// objects as in the selective renderer. Numbers of 48 bits are pairs of 24 bits, which products keep exact.
function randomHalf() {
  var wanted = [];
  var lots = split(lotLengths, lotMembers);
  for (var i = 0; i < lots.length; i++) {
    drawHalf(lots[i], newRandom(seed + lotSeeds[i]), wanted);
  }
  return wanted;
}

function drawHalf(drawn, random, wanted) {
  var low = Math.floor(drawn.length / 2);
  if (drawn.length % 2 == 1 && random.bits(1) == 1) {
    low++;
  }
  for (var size = drawn.length; size > 1; size--) {
    var other = random.below(size);
    var kept = drawn[size - 1];
    drawn[size - 1] = drawn[other];
    drawn[other] = kept;
  }
  for (var j = 0; j < drawn.length; j++) {
    wanted[drawn[j]] = j < low ? least[drawn[j]] : most[drawn[j]];
  }
}

function newRandom(number) {
  var HALF = 16777216;
  var spread = multiply([Math.floor(number / HALF) & (HALF - 1), ((number % HALF) + HALF) % HALF], [7977343, 4881429]);
  var state = [spread[0] ^ 0x5DE, spread[1] ^ 0xECE66D];

  function multiply(a, b) {
    var low = a[1] * b[1];
    var high = a[0] * b[1] + a[1] * b[0] + Math.floor(low / HALF);
    return [high % HALF, low % HALF];
  }

  function bits(count) {
    var next = multiply(state, [0x5DE, 0xECE66D]);
    var low = next[1] + 11;
    state = [(next[0] + Math.floor(low / HALF)) % HALF, low % HALF];
    return Math.floor((state[0] * HALF + state[1]) / Math.pow(2, 48 - count));
  }

  function below(bound) {
    if ((bound & -bound) == bound) {
      return Math.floor(bits(31) / (2147483648 / bound));
    }
    for (;;) {
      var drawn = bits(31);
      var value = drawn % bound;
      if (drawn - value + bound - 1 <= 2147483647) {
        return value;
      }
    }
  }

  return { bits: bits, below: below };
}

// Cuts a flat list into pieces of these lengths.
function split(lengths, values) {
  var pieces = [];
  var at = 0;
  for (var i = 0; i < lengths.length; i++) {
    var piece = [];
    for (var j = 0; j < lengths[i]; j++) {
      piece.push(values[at++]);
    }
    pieces.push(piece);
  }
  return pieces;
}

function indexOf(list, value) {
  for (var i = 0; i < list.length; i++) {
    if (list[i] == value) {
      return i;
    }
  }
  return -1;
}

// No schema's name is that of a member which every object has.
function keyOf(schema) {
  return 'schema ' + schema;
}

// Below stands what has one line for each area and object: the inputs from the ProximitySensors, and send, which
// writes the output that a ROUTE takes to the Switch or the field.
