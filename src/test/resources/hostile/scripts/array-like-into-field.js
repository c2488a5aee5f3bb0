// Something that says it has a billion elements, into an MF field.
function initialize() { numbers = {length: 1e9}; }
