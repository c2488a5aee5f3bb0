// BigInt by its name and by what gives it.
function initialize() { var B = (0, eval)('this').BigInt; Object(B(2) ** B(1e8)); }
